#include "app/cli/compare_options.h"
#include "app/cli/design_input.h"
#include "app/cli/picture_options.h"
#include "app/cli/progress.h"
#include "app/cli/verbs.h"
#include "app/headless/offscreen_context.h"
#include "app/preview/render.h"
#include "core/design/design_file.h"
#include "core/exchange/image_file.h"

namespace nacre::cli {
namespace {

struct RenderOptions {
    std::string design;
    std::string image;
    glm::ivec2 size{800, 800};
    SceneOptions scene;
    CompareOptions compare;
};

int render(const RenderOptions& options, Interrupt& interrupt) {
    const ImageFormat format = image_format(options.image);
    const Design design = load_design(options.design);
    const Scene scene = options.scene.scene();
    const auto context = make_offscreen_context({16, 16});
    const bool linear = format == ImageFormat::exr;
    RenderedImage image;
    if (!options.compare.model.empty()) {
        image = render_comparison(options.compare, design, options.design, scene, options.size, linear,
                                  options.scene.samples, interrupt);
    } else {
        Progress progress("rendering");
        image = about_file(options.design, [&] {
            return render_design(
                design, scene, options.size, linear, interrupt.token(),
                [&](double done) { progress.report(done); }, options.scene.samples);
        });
    }
    interrupt.write_files([&] { write_image(options.image, image.size, image.rgb); });
    return 0;
}

}  // namespace

void declare_render(Command& command, Action& action) {
    const auto options = std::make_shared<RenderOptions>();
    command.option("DESIGN", options->design, "a .nacre file").required();
    command.option("-o,--output", options->image, "a .png (filmic, sRGB) or .exr (linear radiance) file")
        .required();
    add_size_option(command, options->size, 16);
    add_scene_options(command, options->scene);
    add_compare_options(command, options->compare);
    command.when_chosen([options, &action] {
        action = [options](Interrupt& interrupt) { return render(*options, interrupt); };
    });
}

}  // namespace nacre::cli
