#include "core/formats/web_shader.h"

#include <fmt/core.h>

#include <stdexcept>

#include "core/formats/glsl_text.h"
#include "core/formats/web_text.h"
#include "core/shading/shader_variant.h"
#include "shaders/shader_text.h"

namespace nacre {
namespace {

// A shader of the surface with its numbers as constants, which leaves the few uniforms of a telephone alone.
std::string surface_text(const Shading<double>& shading, std::string_view main) {
    return with_text(fragment_shader(variant_of(shading), main), shader_text("uniforms.glsl"),
                     surface_constants(shading) + "\n" + sampler_fetch("surface_data"));
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return text;
}

// One line of page.frag at a time.
class Assembly {
  public:
    explicit Assembly(const Shading<double>& shading) : shading_(shading) {}

    void add(std::string_view line) {
        constexpr std::string_view with = "@with ", part = "@part ", arrow = " =>";
        if (line.starts_with(with)) {
            line.remove_prefix(with.size());
            const std::size_t at = line.find(arrow);
            part_ = with_text(part_, line.substr(0, at), trimmed(line.substr(at + arrow.size())));
            return;
        }
        finish_part();
        if (line.starts_with(part)) {
            line.remove_prefix(part.size());
            const bool of_surface = line == "surface.frag" || line == "accumulate.frag";
            part_ = of_surface ? surface_text(shading_, line) : std::string(shader_text(line));
        } else {
            text_ += std::string(line) + "\n";
        }
    }

    std::string finish() {
        finish_part();
        return without_comments(text_);
    }

  private:
    void finish_part() {
        text_ += part_;
        part_.clear();
    }

    const Shading<double>& shading_;
    std::string text_, part_;
};

}  // namespace

std::string with_text(std::string text, std::string_view from, std::string_view to) {
    std::size_t at = text.find(from);
    if (from.empty() || at == text.npos)
        throw std::logic_error(fmt::format("the shaders do not hold: {}", from));
    for (; at != text.npos; at = text.find(from, at + to.size())) text.replace(at, from.size(), to);
    return text;
}

std::string web_fragment_shader(const Shading<double>& shading, std::string_view main) {
    Assembly assembly(shading);
    for (const std::string_view name : {std::string_view("head.frag"), main}) {
        const std::string_view text = web_text(name);
        for (std::size_t begin = 0; begin < text.size();) {
            const std::size_t end = text.find('\n', begin);
            assembly.add(text.substr(begin, end - begin));
            begin = end + 1;
        }
    }
    return assembly.finish();
}

std::string web_vertex_shader() {
    return without_comments(
        with_text(std::string(shader_text("full_screen.vert")), "#version 330 core", "#version 300 es"));
}

}  // namespace nacre
