#include <stdexcept>

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
    std::string compare;
};

int render(const RenderOptions& options, Interrupt& interrupt) {
    if (!options.compare.empty())
        throw std::runtime_error("--compare " + options.compare + ": comparing has not arrived yet");
    const ImageFormat format = image_format(options.image);
    const Design design = load_design(options.design);
    const Scene scene = options.scene.scene();
    const auto context = make_offscreen_context({16, 16});
    RenderedImage image;
    {
        Progress progress("rendering");
        image = about_file(options.design, [&] {
            return render_design(design, scene, options.size, format == ImageFormat::exr, interrupt.token(),
                                 [&](double done) { progress.report(done); });
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
    command.option("--compare", options->compare, "another model beside it; not in this version");
    command.when_chosen([options, &action] {
        action = [options](Interrupt& interrupt) { return render(*options, interrupt); };
    });
}

}  // namespace nacre::cli
