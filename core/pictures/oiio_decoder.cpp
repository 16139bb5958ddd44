#include <OpenImageIO/imageio.h>
#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "core/base/system/quiet.h"
#include "core/pictures/decoders.h"
#include "core/pictures/picture_problem.h"

namespace nacre {
namespace {

constexpr int channels_max = 1024;
constexpr int window_max = 1 << 15;               // pixels a side of a data window
constexpr std::size_t band_bytes_max = 1u << 30;  // of a row of tiles

// The reason that the reader gives; asking also keeps it from being printed when the reader goes.
std::string reason_of(OIIO::ImageInput& input) {
    const std::string reason = input.geterror();
    return reason.empty() ? "the picture is damaged" : reason;
}

// Where rows of the file go in the picture that is shown: what lies outside is cut off.
struct Window {
    int x = 0, y = 0, width = 0, height = 0;  // the display's
    explicit Window(const OIIO::ImageSpec& spec, bool has_display)
        : x(has_display ? spec.full_x : spec.x),
          y(has_display ? spec.full_y : spec.y),
          width(has_display ? spec.full_width : spec.width),
          height(has_display ? spec.full_height : spec.height) {}
};

class OiioDecoder : public Decoder {
  public:
    explicit OiioDecoder(OpenedFile file)
        : file_(std::move(file)), proxy_(make_proxy()), window_(OIIO::ImageSpec(), false) {
        input_ = OIIO::ImageInput::create(file_.examined.format);
        if (!input_) throw PictureProblem(OIIO::geterror());
        input_->threads(1);  // its ways in several threads leave errors out
        OIIO::ImageSpec as_stored;
        as_stored.attribute("oiio:UnassociatedAlpha", 1);
        // Of a BMP's runs it writes three colours where it has announced a grey.
        if (file_.examined.has_runs) as_stored.attribute("bmp:monochrome_detect", 0);
        std::string name = file_.bytes->path().string();
        if (input_->supports("ioproxy"))
            input_->set_ioproxy(proxy_.get());
        else
            name = file_.bytes->held_path().string();
        if (!input_->open(name, spec_, as_stored)) throw PictureProblem(reason_of(*input_));
        read_header();
    }

    ~OiioDecoder() override {
        const Quiet quiet;
        input_.reset();
    }

    void decode_rows(const std::function<void(int, PixelRow)>& take) override {
        const Quiet quiet;
        // A row that the file does not have is dark and transparent.
        row_.assign(static_cast<std::size_t>(window_.width), glm::vec4(0));
        const int first = std::clamp(spec_.y - window_.y, 0, window_.height);
        const int last = std::clamp(spec_.y + spec_.height - window_.y, first, window_.height);
        for (int y = 0; y < first; ++y) take(y, row_);
        const int step = spec_.tile_height > 0 ? spec_.tile_height : 1;
        int y = first;
        while (y < last) {
            // Rows of tiles start where the file's data does.
            const int from = (y + window_.y - spec_.y) / step * step + spec_.y;
            const int to = std::min(from + step, spec_.y + spec_.height);
            read_band(from, to);
            for (; y < last && y + window_.y < to; ++y) {
                fill_row(static_cast<std::size_t>(y + window_.y - from));
                take(y, row_);
            }
        }
        row_.assign(row_.size(), glm::vec4(0));
        for (; y < window_.height; ++y) take(y, row_);
    }

  private:
    std::unique_ptr<OIIO::Filesystem::IOProxy> make_proxy() {
        std::vector<Piece> pieces = file_.examined.pieces;
        if (pieces.empty()) pieces.push_back({{}, 0, file_.bytes->size()});
        auto proxy = std::make_unique<PieceProxy>(*file_.bytes, std::move(pieces));
        if (file_.examined.format != "jpeg") return proxy;
        // OpenImageIO's reader of JPEG takes memory alone.
        memory_.resize(proxy->size());
        memory_.resize(proxy->pread(memory_.data(), memory_.size(), 0));
        return std::make_unique<OIIO::Filesystem::IOMemReader>(memory_.data(), memory_.size());
    }

    void read_header() {
        if (spec_.width < 1 || spec_.height < 1 || spec_.depth > 1 || spec_.deep)
            throw PictureProblem("no flat picture");
        // TIFF tells where on a page the picture lies, and only with a size of its own that it is a part.
        const bool is_part = spec_.full_width != spec_.width || spec_.full_height != spec_.height;
        window_ = Window(spec_, file_.examined.format == "openexr" || (is_part && spec_.full_width > 0));
        header_.orientation = file_.examined.orientation;
        if (header_.orientation == 0) header_.orientation = spec_.get_int_attribute("Orientation", 1);
        if (header_.orientation < 1 || header_.orientation > 8) header_.orientation = 1;
        header_.size = {window_.width, window_.height};
        check_size(header_.size, header_.orientation, file_.limits);
        if (spec_.nchannels < 1 || spec_.nchannels > channels_max)
            throw PictureProblem(fmt::format("{} channels, must be 1 to {}", spec_.nchannels, channels_max));
        if (spec_.width > window_max || spec_.height > window_max)
            throw PictureProblem(fmt::format("{} x {} pixels of data, more than {} a side", spec_.width,
                                             spec_.height, window_max));
        choose();
        header_.encoded = !spec_.format.is_floating_point();
        header_.bits = static_cast<int>(spec_.format.size() * 8);
        header_.associated = header_.has_alpha && is_associated();
        header_.gamma = file_.examined.gamma;
        header_.to_rec709 = file_.examined.to_rec709;
        header_.notes.insert(header_.notes.begin(), file_.examined.notes.begin(), file_.examined.notes.end());
        check_claim();
    }

    // By what each format defines; readers do not all say what they did.
    bool is_associated() const {
        const std::string& format = file_.examined.format;
        return format == "openexr" || file_.examined.is_associated ||
               (format == "tiff" && spec_.get_int_attribute("oiio:UnassociatedAlpha") == 0);
    }

    void choose() {
        channels_ = choose_channels(spec_.channelnames, file_.use, file_.examined.format == "openexr");
        if (channels_.alpha < 0 && spec_.nchannels > 1) channels_.alpha = spec_.alpha_channel;
        if (file_.use == PictureUse::data || file_.examined.has_no_alpha) channels_.alpha = -1;
        header_.channels = static_cast<int>(channels_.colour.size());
        header_.has_alpha = channels_.alpha >= 0;
        if (!channels_.note.empty()) header_.notes.push_back(channels_.note);
        if (spec_.tile_width == 0) {
            first_channel_ = 0;
            last_channel_ = spec_.nchannels - 1;
            return;
        }
        first_channel_ = *std::min_element(channels_.colour.begin(), channels_.colour.end());
        last_channel_ = *std::max_element(channels_.colour.begin(), channels_.colour.end());
        if (channels_.alpha >= 0) {
            first_channel_ = std::min(first_channel_, channels_.alpha);
            last_channel_ = std::max(last_channel_, channels_.alpha);
        }
    }

    // A file without compression has the bytes that it says it has; the memory that is taken at once is
    // bounded.
    void check_claim() const {
        const std::string compression = spec_.get_string_attribute("compression", "unknown");
        const auto bytes = static_cast<double>(spec_.image_bytes(true));
        const double of_file = static_cast<double>(file_.bytes->size());
        const int meaning = spec_.get_int_attribute("tiff:PhotometricInterpretation", -1);
        const bool is_plain = meaning >= 0 && meaning <= 2 && compression == "none" &&
                              spec_.get_int_attribute("oiio:BitsPerSample") == header_.bits;
        if (file_.examined.format == "tiff" && is_plain && bytes > of_file)
            throw PictureProblem(fmt::format("its {} x {} pixels need {} bytes, the file has {}", spec_.width,
                                             spec_.height, bytes, of_file));
        const std::size_t across = static_cast<std::size_t>(spec_.width) *
                                   static_cast<std::size_t>(std::max(spec_.tile_height, 1)) *
                                   static_cast<std::size_t>(spec_.nchannels) * sizeof(float);
        if (spec_.tile_depth > 1 || across > band_bytes_max || spec_.tile_width > window_max ||
            spec_.tile_height > window_max)
            throw PictureProblem(fmt::format("tiles of {} x {} pixels with {} channels", spec_.tile_width,
                                             spec_.tile_height, spec_.nchannels));
    }

    int band_channels() const { return last_channel_ - first_channel_ + 1; }

    // Rows of the file into band_, one line or one tile at a time: what reads several at once leaves errors
    // out.
    void read_band(int from, int to) {
        const auto channels = static_cast<std::size_t>(band_channels());
        const std::size_t row = static_cast<std::size_t>(spec_.width) * channels;
        band_.assign(row * static_cast<std::size_t>(to - from), unwritten());
        const int end = last_channel_ + 1;
        // Not read_scanlines(), which takes 64 MiB for each call.
        if (spec_.tile_width == 0) check(input_->read_scanline(from, 0, OIIO::TypeDesc::FLOAT, band_.data()));
        for (int x = 0; spec_.tile_width > 0 && x < spec_.width; x += spec_.tile_width) {
            const int right = std::min(x + spec_.tile_width, spec_.width);
            check(input_->read_tiles(0, 0, spec_.x + x, spec_.x + right, from, to, 0, 1, first_channel_, end,
                                     OIIO::TypeDesc::FLOAT, &band_[static_cast<std::size_t>(x) * channels],
                                     static_cast<OIIO::stride_t>(channels * sizeof(float)),
                                     static_cast<OIIO::stride_t>(row * sizeof(float))));
        }
    }

    void check(bool was_read) {
        if (!was_read || input_->has_error()) throw PictureProblem(reason_of(*input_));
    }

    // row_ from a line of band_.
    void fill_row(std::size_t line) {
        const auto channels = static_cast<std::size_t>(band_channels());
        const int left = std::clamp(spec_.x - window_.x, 0, window_.width);
        const int right = std::clamp(spec_.x + spec_.width - window_.x, left, window_.width);
        const float* pixel = &band_[(line * static_cast<std::size_t>(spec_.width) +
                                     static_cast<std::size_t>(std::max(window_.x - spec_.x, 0))) *
                                    channels];
        const std::vector<int>& colour = channels_.colour;
        const int r = colour[0] - first_channel_;
        const int g = colour.size() == 1 ? r : colour[1] - first_channel_;
        const int b = colour.size() == 3 ? colour[2] - first_channel_ : r;
        for (int x = left; x < right; ++x, pixel += channels) {
            glm::vec4& value = row_[static_cast<std::size_t>(x)];
            value = {pixel[r], pixel[g], colour.size() == 2 ? 0.0f : pixel[b],
                     channels_.alpha >= 0 ? pixel[channels_.alpha - first_channel_] : 1.0f};
        }
    }

    OpenedFile file_;
    std::string memory_;
    std::unique_ptr<OIIO::Filesystem::IOProxy> proxy_;
    std::unique_ptr<OIIO::ImageInput> input_;
    OIIO::ImageSpec spec_;
    Window window_;
    Channels channels_;
    int first_channel_ = 0, last_channel_ = 0;  // of band_: all of a line, of tiles those between
    std::vector<float> band_;
    std::vector<glm::vec4> row_;
};

}  // namespace

std::unique_ptr<Decoder> make_oiio_decoder(OpenedFile file) {
    const Quiet quiet;
    return std::make_unique<OiioDecoder>(std::move(file));
}

}  // namespace nacre
