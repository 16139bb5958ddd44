#include <webp/decode.h>
#include <webp/demux.h>

#include <cstdint>
#include <utility>

#include "core/pictures/decoders.h"
#include "core/pictures/picture_problem.h"

namespace nacre {
namespace {

class WebpDecoder : public Decoder {
  public:
    explicit WebpDecoder(OpenedFile file) : file_(std::move(file)) {
        header_.size = file_.examined.size;
        header_.orientation = file_.examined.orientation;
        header_.encoded = true;
        header_.bits = 8;
        header_.notes = file_.examined.notes;
        bytes_ = file_.bytes->read(0, file_.bytes->size());
        if (WebPGetFeatures(data(), bytes_.size(), &features_) != VP8_STATUS_OK ||
            features_.width != header_.size.x || features_.height != header_.size.y)
            throw PictureProblem("the WebP file is damaged");
        header_.has_alpha = features_.has_alpha != 0 && file_.use == PictureUse::light;
    }

    void decode_rows(const std::function<void(int, PixelRow)>& take) override {
        const auto width = static_cast<std::size_t>(header_.size.x);
        std::vector<std::uint8_t> pixels(4 * width * static_cast<std::size_t>(header_.size.y));
        if (features_.has_animation != 0)
            decode_first_frame(pixels);
        else if (WebPDecodeRGBAInto(data(), bytes_.size(), pixels.data(), pixels.size(),
                                    4 * header_.size.x) == nullptr)
            throw PictureProblem("the WebP file is damaged");
        std::vector<glm::vec4> row(width);
        const std::uint8_t* pixel = pixels.data();
        for (int y = 0; y < header_.size.y; ++y) {
            for (std::size_t x = 0; x < width; ++x, pixel += 4)
                row[x] = glm::vec4(pixel[0], pixel[1], pixel[2], header_.has_alpha ? pixel[3] : 255) / 255.0f;
            take(y, row);
        }
    }

  private:
    const std::uint8_t* data() const { return reinterpret_cast<const std::uint8_t*>(bytes_.data()); }

    // It may be smaller than the picture, which is transparent beside it.
    void decode_first_frame(std::vector<std::uint8_t>& pixels) {
        const WebPData file{data(), bytes_.size()};
        const std::unique_ptr<WebPAnimDecoder, decltype(&WebPAnimDecoderDelete)> decoder(
            WebPAnimDecoderNew(&file, nullptr), WebPAnimDecoderDelete);
        std::uint8_t* frame = nullptr;
        int time = 0;
        if (!decoder || WebPAnimDecoderGetNext(decoder.get(), &frame, &time) == 0)
            throw PictureProblem("the WebP file is damaged");
        std::copy(frame, frame + pixels.size(), pixels.begin());
    }

    OpenedFile file_;
    std::string bytes_;
    WebPBitstreamFeatures features_{};
};

}  // namespace

std::unique_ptr<Decoder> make_webp_decoder(OpenedFile file) {
    return std::make_unique<WebpDecoder>(std::move(file));
}

}  // namespace nacre
