#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "app/cli/output.h"
#include "app/cli/output_option.h"
#include "app/cli/picture_options.h"
#include "app/cli/progress.h"
#include "app/cli/verbs.h"
#include "app/headless/offscreen_context.h"
#include "app/preview/filmic.h"
#include "app/preview/preview.h"
#include "app/preview/render.h"
#include "core/base/system/atomic_file.h"
#include "core/base/system/output_folder.h"
#include "core/base/system/output_guard.h"
#include "core/image/srgb.h"
#include "core/study/paper_page.h"

namespace nacre::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* page_name = "index.html";

struct PaperOptions {
    std::string folder;
    glm::ivec2 size{480, 480};
    std::vector<std::string> only;
};

class PreviewRenderer final : public PaperRenderer {
  public:
    PaperImage draw(const ComparedSurface& surface, const PaperView& view, glm::ivec2 size) override {
        Scene scene;
        scene.object = make_object(view.object);
        scene.light.theta = view.theta;
        scene.light.phi = view.phi;
        scene.pitch = view.pitch;
        scene.yaw = view.yaw;
        scene.zoom = view.zoom;
        scene.exposure = view.exposure;
        preview_.set(surface.tables, surface.model);
        RenderedImage image = picture_of(preview_, scene, size, false);
        return {image.size, std::move(image.rgb)};
    }
    float shown(double radiance) const override { return static_cast<float>(srgb_encoded(filmic(radiance))); }

  private:
    Preview preview_;
};

std::vector<std::string> part_names() {
    std::vector<std::string> names;
    for (const PaperPart* part : paper_parts()) names.emplace_back(part->name);
    return names;
}

std::vector<MadePart> make_parts(const PaperOptions& options, const Interrupt& interrupt) {
    std::vector<const PaperPart*> wanted;
    for (const PaperPart* part : paper_parts())
        if (options.only.empty() ||
            std::find(options.only.begin(), options.only.end(), part->name) != options.only.end())
            wanted.push_back(part);
    const auto context = make_offscreen_context({16, 16});
    PreviewRenderer renderer;
    Baker baker;
    std::vector<MadePart> made;
    Progress progress("the paper");
    for (const PaperPart* part : wanted) {
        progress.report(static_cast<double>(made.size()) / static_cast<double>(wanted.size()));
        interrupt.check();
        made.push_back({part, part->make({renderer, baker, options.size, interrupt.token()})});
    }
    return made;
}

int paper(const PaperOptions& options, Interrupt& interrupt) {
    // Whether it can be had, at once; then again when there is something to put there, since a stop while a
    // picture is drawn ends the program as it is.
    { const OutputFolder trial(options.folder); }
    const std::vector<MadePart> made = make_parts(options, interrupt);
    const OutputFolder folder(options.folder);
    const std::string page = paper_page(made);
    // The page comes last: it describes the others.
    std::vector<FileToWrite> files;
    std::vector<fs::path> outputs;
    for (const MadePart& part : made)
        for (const PaperPicture& picture : part.result.pictures)
            files.push_back({fs::path(options.folder) / picture.file, picture.bytes});
    files.push_back({fs::path(options.folder) / page_name, page});
    for (const FileToWrite& file : files) outputs.push_back(file.file);
    check_outputs(outputs, {});
    interrupt.write_files([&] { write_files_atomically(files); });
    write_output(fmt::format("{} pictures and {} in {}\n", files.size() - 1, page_name, options.folder));
    return 0;
}

void declare(Command& command, Action& action) {
    const auto options = std::make_shared<PaperOptions>();
    add_folder_option(command, options->folder,
                      "the folder for the page, made when it is not there; the page is index.html");
    add_size_option(command, options->size, 16);
    command
        .option("--only", options->only,
                fmt::format("one of its parts, or several: {}", fmt::join(part_names(), ", ")))
        .one_of(part_names());
    command.when_chosen([options, &action] {
        action = [options](Interrupt& interrupt) { return paper(*options, interrupt); };
    });
}

}  // namespace

const Verb paper_verb{"paper", "the figures and numbers of the paper again, beside what it says", declare};

}  // namespace nacre::cli
