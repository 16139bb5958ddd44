#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "app/cli/contact_sheet.h"
#include "app/cli/design_input.h"
#include "app/cli/message.h"
#include "app/cli/output.h"
#include "app/cli/output_names.h"
#include "app/cli/output_option.h"
#include "app/cli/picture_options.h"
#include "app/cli/progress.h"
#include "app/cli/verbs.h"
#include "app/headless/offscreen_context.h"
#include "core/base/system/atomic_file.h"
#include "core/base/system/output_folder.h"
#include "core/base/system/output_guard.h"
#include "core/design/design_file.h"
#include "core/design/picture_files.h"
#include "core/image/image_file.h"

namespace nacre::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char *sheet_name = "contact-sheet", *picture_extension = ".png";

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

// contact-sheet, contact-sheet-2 and so on.
std::vector<std::string> sheets_of(std::size_t designs) {
    std::vector<std::string> names{sheet_name};
    for (std::size_t i = 2; i <= (designs + sheet_pictures_max - 1) / sheet_pictures_max; ++i)
        names.push_back(fmt::format("{}-{}", sheet_name, i));
    return names;
}

// The picture of each design, all of them other files than the contact sheets.
std::vector<fs::path> pictures_of(const std::vector<fs::path>& designs,
                                  const std::vector<std::string>& sheets, const fs::path& folder) {
    std::vector<std::string> stems;
    for (const fs::path& design : designs) stems.push_back(design.stem().string());
    std::vector<fs::path> pictures;
    for (const std::string& name : distinct_names(stems, sheets, folder))
        pictures.push_back(folder / (name + picture_extension));
    return pictures;
}

// Before any picture is written, since one may be what a later design refers to. A design that cannot be read
// is told when its turn comes.
void check_all(const std::vector<fs::path>& designs, const std::vector<fs::path>& outputs,
               const SceneOptions& scene, const Interrupt& interrupt) {
    std::vector<fs::path> inputs = scene.files();
    inputs.insert(inputs.end(), designs.begin(), designs.end());
    for (const fs::path& file : designs) {
        interrupt.check();
        try {
            const std::vector<fs::path> files = files_of(load_design(file), file);
            inputs.insert(inputs.end(), files.begin(), files.end());
        } catch (const UserError&) {
        }
    }
    check_outputs(outputs, inputs);
}

struct Rendered {
    std::string name;
    RenderedImage image;
};

Rendered render_one(const fs::path& file, const GalleryOptions& options, const Scene& scene,
                    const Interrupt& interrupt) {
    const Design design = load_design(file);
    RenderedImage image = about_file(file, [&] {
        return render_design(design, scene, options.size, false, interrupt.token(), {},
                             options.scene.samples);
    });
    return {one_line(design.name.empty() ? file.stem().string() : design.name), std::move(image)};
}

// Each sheet is written when it is full, so that no more than one is held.
class SheetWriter {
  public:
    SheetWriter(std::vector<std::string> names, fs::path folder, Interrupt& interrupt)
        : names_(std::move(names)), folder_(std::move(folder)), interrupt_(interrupt) {}

    void add(std::string name, const RenderedImage& image) {
        sheet_.add(std::move(name), image);
        if (sheet_.full()) finish();
    }
    void finish() {
        if (sheet_.empty()) return;
        const RenderedImage picture = sheet_.take();
        const ImageBytes bytes = image_bytes(ImageFormat::png, picture.size, picture.rgb);
        const fs::path file = folder_ / (names_[written_++] + picture_extension);
        interrupt_.write_files([&] { write_file_atomically(file, text_of(bytes)); });
    }
    // What was written, in words.
    std::string text() const {
        return written_ == 1 ? names_.front() + picture_extension
                             : fmt::format("{} contact sheets", written_);
    }

  private:
    std::vector<std::string> names_;
    fs::path folder_;
    Interrupt& interrupt_;
    ContactSheet sheet_;
    std::size_t written_ = 0;
};

int gallery(const GalleryOptions& options, Interrupt& interrupt) {
    const std::vector<fs::path> files = designs_in(options.designs);
    const std::vector<std::string> sheet_names = sheets_of(files.size());
    const std::vector<fs::path> targets = pictures_of(files, sheet_names, options.output);
    std::vector<fs::path> outputs = targets;
    for (const std::string& name : sheet_names)
        outputs.push_back(fs::path(options.output) / (name + picture_extension));
    check_all(files, outputs, options.scene, interrupt);
    const Scene scene = options.scene.scene();
    const OutputFolder folder(options.output);
    const auto context = make_offscreen_context({16, 16});
    SheetWriter sheets(sheet_names, options.output, interrupt);
    std::size_t written = 0;
    std::vector<std::string> problems;
    {
        Progress progress("rendering");
        for (std::size_t i = 0; i < files.size(); ++i) {
            progress.report(static_cast<double>(i) / static_cast<double>(files.size()));
            Rendered rendered;
            try {
                rendered = render_one(files[i], options, scene, interrupt);
            } catch (const UserError& error) {
                problems.emplace_back(error.what());
                continue;
            }
            const ImageBytes bytes = image_bytes(ImageFormat::png, rendered.image.size, rendered.image.rgb);
            interrupt.write_files([&] { write_file_atomically(targets[i], text_of(bytes)); });
            sheets.add(rendered.name, rendered.image);
            ++written;
        }
        sheets.finish();
    }
    for (const std::string& problem : problems) complain(problem);
    write_output(fmt::format("{} pictures and {} in {}\n", written, sheets.text(), options.output));
    return problems.empty() ? 0 : 1;
}

void declare(Command& command, Action& action) {
    const auto options = std::make_shared<GalleryOptions>();
    command.option("DIR", options->designs, "a folder of .nacre files")
        .required()
        .check(no_stream("must be a folder"));
    add_folder_option(command, options->output, "the folder for the pictures, made when it is not there");
    add_size_option(command, options->size, 16);
    add_scene_options(command, options->scene);
    command.when_chosen([options, &action] {
        action = [options](Interrupt& interrupt) { return gallery(*options, interrupt); };
    });
}

}  // namespace

const Verb gallery_verb{"gallery", "every design of a folder rendered, with a contact sheet", declare};

}  // namespace nacre::cli
