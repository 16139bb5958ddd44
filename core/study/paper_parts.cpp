#include "core/study/paper_parts.h"

#include <fmt/core.h>

#include <utility>

#include "core/formats/plot_files.h"
#include "core/image/image_file.h"
#include "core/study/ward.h"

namespace nacre {

PaperPicture png_picture(const std::string& name, std::string caption, const PaperImage& image) {
    const ImageBytes bytes = image_bytes(ImageFormat::png, image.size, image.rgb);
    return {name + ".png", std::move(caption), std::string(text_of(bytes))};
}

PaperPicture svg_picture(const std::string& name, std::string caption, const Plot& plot) {
    return {name + ".svg", std::move(caption), plot_svg(plot)};
}

Plot curve_plot(std::string title, std::string subtitle, CurvePlot curves) {
    return {.title = std::move(title), .subtitle = std::move(subtitle), .contents = std::move(curves)};
}

PaperImage draw_design(const PaperTools& tools, const Design& design, const PaperView& view) {
    return tools.renderer.draw({tools.baker.bake(design, {}, tools.stop), nullptr}, view, tools.size);
}

PaperImage draw_ward(const PaperTools& tools, const Design& design, dvec2 alpha, const PaperView& view) {
    auto ward = std::make_shared<ClosedForm>();
    ward->form = ward_form(alpha);
    return tools.renderer.draw({tools.baker.bake(design, {}, tools.stop), std::move(ward)}, view, tools.size);
}

std::string percent_text(double part) {
    return fmt::format("{:.{}f} %", 100 * part, part < 0.002 ? 2 : part < 0.02 ? 1 : 0);
}

}  // namespace nacre
