
#include "app/cli/picture_options.h"
#include "app/cli/verbs.h"
#include "app/headless/screenshot.h"
#include "core/design/error.h"
#include "core/exchange/image_file.h"

namespace nacre::cli {
namespace {

struct ScreenshotVerbOptions {
    std::string design;
    std::string image;
    std::string script;
    glm::ivec2 size{1280, 800};
    float ui_scale = 1;
};

int take_screenshot(const ScreenshotVerbOptions& options, Interrupt& interrupt) {
    if (image_format(options.image) != ImageFormat::png)
        throw UserError(options.image, "write", "a screenshot is a .png file");
    ScreenshotOptions wanted{.design = {}, .script = {}, .size = options.size, .ui_scale = options.ui_scale};
    if (!options.design.empty()) wanted.design = options.design;
    if (!options.script.empty()) wanted.script = options.script;
    const Screenshot picture = screenshot(wanted);
    interrupt.write_files([&] { write_png(options.image, picture.size, picture.rgba); });
    return 0;
}

}  // namespace

void declare_screenshot(Command& command, Action& action) {
    const auto options = std::make_shared<ScreenshotVerbOptions>();
    command.option("DESIGN", options->design, "a .nacre file; without it, a new design");
    command.option("-o,--output", options->image, "a .png file").required();
    add_size_option(command, options->size, 200);
    command.option("--script", options->script, "input events to play first, one a line");
    command.option("--ui-scale", options->ui_scale, "size of text and widgets; 1 is normal").within(0.5, 4.0);
    command.when_chosen([options, &action] {
        action = [options](Interrupt& interrupt) { return take_screenshot(*options, interrupt); };
    });
}

}  // namespace nacre::cli
