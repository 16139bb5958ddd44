#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "app/cli/contact_sheet.h"
#include "app/cli/design_input.h"
#include "app/cli/output.h"
#include "app/cli/picture_options.h"
#include "app/cli/progress.h"
#include "app/cli/verbs.h"
#include "app/headless/offscreen_context.h"
#include "core/design/design_file.h"
#include "core/exchange/image_file.h"

namespace nacre::cli {
namespace {

namespace fs = std::filesystem;

struct GalleryOptions {
    std::string designs;
    std::string output;
    glm::ivec2 size{512, 512};
    SceneOptions scene;
};

std::vector<fs::path> designs_in(const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> files;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (entry->path().extension() == ".nacre") files.push_back(entry->path());
    if (error) throw UserError(folder.string(), "open", "the folder cannot be read", error.message());
    if (files.empty()) throw UserError(folder.string(), "open", "the folder holds no .nacre file");
    std::sort(files.begin(), files.end());
    return files;
}

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error || !fs::is_directory(folder))
        throw UserError(folder.string(), "write", "the folder cannot be made",
                        error ? error.message() : "it is no folder");
}

SheetPicture render_one(const fs::path& file, const GalleryOptions& options, const Scene& scene,
                        const Interrupt& interrupt) {
    const Design design = load_design(file);
    RenderedImage image = about_file(file, [&] {
        return render_design(design, scene, options.size, false, interrupt.token(), {},
                             options.scene.samples);
    });
    return {one_line(design.name.empty() ? file.stem().string() : design.name), std::move(image)};
}

int gallery(const GalleryOptions& options, Interrupt& interrupt) {
    const std::vector<fs::path> files = designs_in(options.designs);
    const Scene scene = options.scene.scene();
    make_folder(options.output);
    const auto context = make_offscreen_context({16, 16});
    std::vector<SheetPicture> pictures;
    std::vector<std::string> problems;
    {
        Progress progress("rendering");
        for (std::size_t i = 0; i < files.size(); ++i) {
            progress.report(static_cast<double>(i) / static_cast<double>(files.size()));
            SheetPicture picture;
            try {
                picture = render_one(files[i], options, scene, interrupt);
            } catch (const UserError& error) {
                problems.emplace_back(error.what());
                continue;
            }
            const fs::path target = fs::path(options.output) / files[i].stem().concat(".png");
            interrupt.write_files([&] { write_image(target, picture.image.size, picture.image.rgb); });
            pictures.push_back(std::move(picture));
        }
    }
    if (!pictures.empty()) {
        const RenderedImage sheet = contact_sheet(pictures);
        interrupt.write_files(
            [&] { write_image(fs::path(options.output) / "contact-sheet.png", sheet.size, sheet.rgb); });
    }
    for (const std::string& problem : problems) fmt::print(stderr, "nacre-cli: {}\n", problem);
    write_output(fmt::format("{} pictures and contact-sheet.png in {}\n", pictures.size(), options.output));
    return problems.empty() ? 0 : 1;
}

}  // namespace

void declare_gallery(Command& command, Action& action) {
    const auto options = std::make_shared<GalleryOptions>();
    command.option("DIR", options->designs, "a folder of .nacre files").required();
    command.option("-o,--output", options->output, "the folder for the pictures, made when it is not there")
        .required();
    add_size_option(command, options->size, 16);
    add_scene_options(command, options->scene);
    command.when_chosen([options, &action] {
        action = [options](Interrupt& interrupt) { return gallery(*options, interrupt); };
    });
}

}  // namespace nacre::cli
