#include "app/cli/design_input.h"
#include "app/cli/output.h"
#include "app/cli/output_option.h"
#include "app/cli/picture_options.h"
#include "app/cli/verbs.h"
#include "app/headless/screenshot.h"
#include "core/base/input_file.h"
#include "core/base/system/output_guard.h"
#include "core/image/image_file.h"

namespace nacre::cli {
namespace {

namespace fs = std::filesystem;

struct ScreenshotVerbOptions {
    std::string design;
    OutputOption output;
    std::string script;
    glm::ivec2 size{1280, 800};
    float ui_scale = 1;
};

// Of the script, also those that are dropped in it.
std::vector<fs::path> inputs(const ScreenshotVerbOptions& options, const ScreenshotOptions& wanted) {
    std::vector<fs::path> files;
    if (wanted.document) files = files_of(wanted.document->design, options.design);
    if (!options.script.empty()) files.emplace_back(options.script);
    for (const Event& event : wanted.script.events)
        if (const auto* const drop = std::get_if<events::Drop>(&event.what)) files.emplace_back(drop->file);
    return files;
}

int take_screenshot(const ScreenshotVerbOptions& options, Interrupt& interrupt) {
    if (image_format(options.output.named()) != ImageFormat::png)
        throw UserError(options.output.file, "write", "a screenshot is a .png file");
    ScreenshotOptions wanted{
        .document = {}, .script = {}, .size = options.size, .ui_scale = options.ui_scale};
    if (!options.script.empty()) wanted.script = parse_events(read_text_file(options.script), options.script);
    if (options.design == stream_name)
        wanted.document = Document(read_design(options.design));
    else if (!options.design.empty())
        wanted.document = read_document(options.design);
    check_outputs(options.output.outputs(), inputs(options, wanted));
    const Screenshot picture = screenshot(wanted);
    write_file_or_output(options.output.file, text_of(png_bytes(picture.size, picture.rgba)), interrupt);
    return 0;
}

void declare(Command& command, Action& action) {
    const auto options = std::make_shared<ScreenshotVerbOptions>();
    command.option("DESIGN", options->design, "a .nacre file; - is standard input; without it, a new design");
    add_output_option(command, options->output, {"png"}, "a .png file");
    add_size_option(command, options->size, 200);
    command.option("--script", options->script, "input events to play first, one a line");
    command.option("--ui-scale", options->ui_scale, "size of text and widgets; 1 is normal").within(0.5, 4.0);
    command.when_chosen([options, &action] {
        action = [options](Interrupt& interrupt) { return take_screenshot(*options, interrupt); };
    });
}

}  // namespace

const Verb screenshot_verb{"screenshot", "the designer's window, as a picture", declare};

}  // namespace nacre::cli
