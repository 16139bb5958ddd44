#include "core/design/source_json.h"

#include <fmt/core.h>

#include "core/base/limits.h"

namespace nacre {
namespace {

using Names = std::array<std::string_view, 2>;

constexpr Names encodings{"unsigned", "signed"}, greens{"up", "down"}, channels{"xyz", "xy"};

void read_either(ObjectReader& reader, std::string_view key, const Names& names, bool& value) {
    value = reader.choice(key, names, value ? 1 : 0) == 1;
}

}  // namespace

PictureSource read_source(const JsonValue& json, const std::filesystem::path& base_dir) {
    ObjectReader reader(json);
    PictureSource source;
    const JsonValue image = reader.required("image", "the path of a picture");
    const std::string path = image.text();
    if (path.empty() || path.find('\0') != path.npos) image.fail("must be the path of a picture");
    source.image = (base_dir / path).lexically_normal();
    reader.required("as", "what the picture was taken for");
    source.as = static_cast<SourceUse>(reader.choice("as", source_uses, 0));
    reader.number("size", source.size, {limits::stamp_size_min, limits::stamp_size_max});
    read_either(reader, "encoding", encodings, source.reading.is_signed);
    read_either(reader, "channels", channels, source.reading.two_channels);
    read_either(reader, "green", greens, source.reading.green_down);
    reader.number("height", source.height, {-limits::relief_max, limits::relief_max});
    reader.number("smoothing", source.smoothing, {0, limits::smoothing_max});
    reader.number("rotation", source.rotation, {-limits::angle_max, limits::angle_max});
    reader.flag("flip", source.flip);
    reader.finish("a source");
    return source;
}

std::string source_text(const PictureSource& source, const std::string& image) {
    const PictureSource usual;
    std::string text = fmt::format("{{\"image\": {}, \"as\": \"{}\"", image,
                                   source_uses.at(static_cast<std::size_t>(source.as)));
    const auto number = [&](const char* key, double value, double otherwise) {
        if (value != otherwise) text += fmt::format(", \"{}\": {}", key, value + 0.0);
    };
    const auto either = [&](const char* key, const Names& names, bool value) {
        if (value) text += fmt::format(", \"{}\": \"{}\"", key, names[1]);
    };
    number("size", source.size, usual.size);
    either("encoding", encodings, source.reading.is_signed);
    either("channels", channels, source.reading.two_channels);
    either("green", greens, source.reading.green_down);
    number("height", source.height, usual.height);
    number("smoothing", source.smoothing, usual.smoothing);
    number("rotation", source.rotation, usual.rotation);
    if (source.flip) text += ", \"flip\": true";
    return text + "}";
}

}  // namespace nacre
