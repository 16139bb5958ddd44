#include "app/cli/compare_options.h"
#include "app/cli/design_input.h"
#include "app/cli/message.h"
#include "app/cli/output.h"
#include "app/cli/output_option.h"
#include "app/cli/picture_options.h"
#include "app/cli/progress.h"
#include "app/cli/verbs.h"
#include "app/headless/offscreen_context.h"
#include "app/preview/render.h"
#include "core/base/system/output_guard.h"
#include "core/image/image_file.h"

namespace nacre::cli {
namespace {

namespace fs = std::filesystem;

struct RenderOptions {
    std::string design;
    OutputOption output;
    glm::ivec2 size{800, 800};
    SceneOptions scene;
    CompareOptions compare;
};

std::vector<fs::path> inputs(const RenderOptions& options, const Design& design,
                             const std::optional<Design>& beside) {
    std::vector<fs::path> files = files_of(design, options.design);
    const auto add = [&](const std::vector<fs::path>& more) {
        files.insert(files.end(), more.begin(), more.end());
    };
    add(options.scene.files());
    if (beside) add(files_of(*beside, options.compare.model));
    return files;
}

int render(const RenderOptions& options, Interrupt& interrupt) {
    const ImageFormat format = image_format(options.output.named());
    const Design design = read_design(options.design);
    const std::optional<Design> beside = design_beside(options.compare);
    check_outputs(options.output.outputs(), inputs(options, design, beside));
    const Scene scene = options.scene.scene();
    const auto context = make_offscreen_context({16, 16});
    const bool linear = format == ImageFormat::exr;
    RenderedImage image;
    if (!options.compare.model.empty()) {
        ComparedImage compared = render_comparison(options.compare, design, options.design, beside, scene,
                                                   options.size, linear, options.scene.samples, interrupt);
        // Standard output is the picture's where it goes there.
        if (options.output.file == stream_name)
            write_message(compared.summary, std::chrono::seconds(10));
        else
            write_output(compared.summary);
        image = std::move(compared.image);
    } else {
        Progress progress("rendering");
        image = about_file(options.design, [&] {
            return render_design(
                design, scene, options.size, linear, interrupt.token(),
                [&](double done) { progress.report(done); }, options.scene.samples);
        });
    }
    write_file_or_output(options.output.file, text_of(image_bytes(format, image.size, image.rgb)), interrupt);
    return 0;
}

void declare(Command& command, Action& action) {
    const auto options = std::make_shared<RenderOptions>();
    command.option("DESIGN", options->design, "a .nacre file; - is standard input").required();
    add_output_option(command, options->output, {"png", "exr"},
                      "a .png (filmic, sRGB) or .exr (linear radiance) file");
    add_size_option(command, options->size, 16);
    add_scene_options(command, options->scene);
    add_compare_options(command, options->compare);
    command.when_chosen([options, &action] {
        check_usage(options->output);
        action = [options](Interrupt& interrupt) { return render(*options, interrupt); };
    });
}

}  // namespace

const Verb render_verb{"render", "the design on an object, as a picture", declare};

}  // namespace nacre::cli
