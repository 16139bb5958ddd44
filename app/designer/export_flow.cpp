#include "app/designer/export_flow.h"

#include <cmath>
#include <exception>
#include <system_error>
#include <utility>

#include "app/designer/folder.h"
#include "core/base/error.h"
#include "core/base/system/output_guard.h"
#include "core/base/system/thread_priority.h"
#include "core/formats/export_format.h"
#include "core/image/image_file.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

struct PictureFormat {
    const char* title;
    const char* about;
    const char* extension;
    bool linear;
    NextSteps next;
};

// Beside the formats of core, what only a window can write.
constexpr PictureFormat pictures[] = {
    {"Picture, PNG", "the preview as it looks: filmic curve, sRGB, 8 bits", ".png", false,
     "{file} looks as the preview does wherever pictures are shown: it is sRGB already."},
    {"Picture, EXR", "the preview's linear radiance times the exposure, float", ".exr", true,
     "Open {file} as linear light, Rec. 709, in a program for compositing.\n"
     "Apply its own view transform: the preview's filmic curve is not in it."},
};

bool is_picture(std::size_t chosen) { return chosen >= export_formats().size(); }

const PictureFormat& picture_format(std::size_t chosen) { return pictures[chosen - export_formats().size()]; }

std::string extension_of(std::size_t chosen) {
    return is_picture(chosen) ? picture_format(chosen).extension
                              : std::string(export_formats()[chosen]->extension);
}

// What writing there would replace, as a question; empty where nothing stands in the way.
std::string replaced(const fs::path& output) {
    std::error_code error;
    if (!fs::exists(output, error)) return {};
    if (!fs::is_directory(output, error)) return output.filename().string() + " exists already.";
    if (fs::is_empty(output, error)) return {};
    return output.filename().string() + " holds files already. Tables of the same names in it are replaced.";
}

}  // namespace

ExportFlow::ExportFlow(fs::path folder_opener) : opener_program_(std::move(folder_opener)) {
    for (const ExportFormat* format : export_formats())
        dialog_.formats.push_back({.title = std::string(format->title),
                                   .about = {},
                                   .holds = {},
                                   .has_names = format->has_names,
                                   .has_error = format->has_error});
    for (const PictureFormat& format : pictures)
        dialog_.formats.push_back(
            {.title = format.title, .about = format.about, .holds = {}, .is_picture = true});
}

// Once for each dialog: whether p leans is found by integrals.
void ExportFlow::tell_holdings(const Design& design) {
    if (std::exchange(held_, true)) return;
    for (std::size_t i = 0; i < export_formats().size(); ++i) {
        const DesignHolding holding = holding_of(*export_formats()[i], design);
        dialog_.formats[i].holds = holding.text;
        dialog_.formats[i].refuses = holding.refused;
    }
}

void ExportFlow::draw_options(const Document& document) {
    dialog_.prefix_problem = prefix_problem(dialog_.prefix);
    tell_holdings(document.design);
    for (std::size_t i = 0; i < export_formats().size(); ++i)
        dialog_.formats[i].about = about(*export_formats()[i], dialog_.prefix);
    const ui::DialogAnswer answer = ui::export_dialog(dialog_);
    if (answer == ui::DialogAnswer::cancelled) step_ = Step::none;
    if (answer == ui::DialogAnswer::accepted) ask_file(document);
}

void ExportFlow::ask_file(const Document& document) {
    step_ = Step::file;
    fs::path folder = existing_folder(settings_->export_folder);
    if (folder.empty()) folder = existing_folder(document.file.parent_path());
    if (folder.empty()) folder = existing_folder(settings_->design_folder);
    const std::string extension = extension_of(dialog_.chosen);
    const bool into_folder = extension.empty();
    chooser_.ask({.purpose = into_folder ? ui::FileDialog::Purpose::folder : ui::FileDialog::Purpose::save,
                  .title = into_folder ? "Export into a folder" : "Export as",
                  .folder = folder,
                  .name = document.stem() + (into_folder ? "-tables" : extension),
                  .kind = into_folder ? "" : dialog_.formats[dialog_.chosen].title,
                  .extensions = into_folder ? std::vector<std::string>() : std::vector{extension}},
                 dialogs_);
}

void ExportFlow::draw_file(const Document& document, PreviewPane& preview, const Scene& scene) {
    const auto answer = chooser_.draw();
    if (!answer) return;
    if (answer->chosen.empty()) {
        step_ = Step::options;
        return;
    }
    output_ = answer->chosen;
    if (!may_write(document.design)) return;
    if (!replaced(output_).empty())
        step_ = Step::replace;
    else
        begin(document, preview, scene);
}

void ExportFlow::draw_question(const Document& document, PreviewPane& preview, const Scene& scene) {
    const auto answer = ui::question("Replace?", replaced(output_), {"Replace", "Cancel"});
    if (!answer) return;
    if (*answer == 0)
        begin(document, preview, scene);
    else
        ask_file(document);
}

// Says why not.
bool ExportFlow::may_write(const Design& design) {
    try {
        check_outputs(is_picture(dialog_.chosen) ? std::vector{output_}
                                                 : export_formats()[dialog_.chosen]->files(design, output_),
                      inputs_());
        return true;
    } catch (const std::exception&) {
        problem_ = problem_line();
        step_ = Step::problem;
        return false;
    }
}

void ExportFlow::begin(const Document& document, PreviewPane& preview, const Scene& scene) {
    try {
        start_work(document, preview, scene);
        step_ = Step::work;
    } catch (const std::exception&) {
        problem_ = problem_line();
        step_ = Step::problem;
    }
}

void ExportFlow::start_work(const Document& document, PreviewPane& preview, const Scene& scene) {
    settings_->export_folder = output_.parent_path();
    written_ = std::make_shared<Written>();
    std::string done = "Exported " + output_.filename().string();
    if (is_picture(dialog_.chosen)) {
        const glm::ivec2 size(std::lround(dialog_.width), std::lround(dialog_.height));
        const bool linear = picture_format(dialog_.chosen).linear;
        task_.start([image = preview.picture(scene, size, linear), output = output_, done,
                     written = written_](const auto&, const auto&) {
            write_image(output, image.size, image.rgb);
            written->files = {output};
            return done;
        });
        return;
    }
    const ExportFormat* format = export_formats()[dialog_.chosen];
    ExportSettings settings{.prefix = dialog_.prefix, .error = dialog_.error};
    settings.bake.tolerance = dialog_.tolerance;
    task_.start([=, design = document.design, output = output_, written = written_](
                    const std::stop_token& stop, const auto& progress) {
        set_niceness(worker_niceness);
        const ExportWriter write = prepare_export(*format, design, settings, stop, progress);
        if (stop.stop_requested()) return std::string();
        written->files = write(output);
        written->notes = write.notes;
        return done;
    });
}

std::optional<std::string> ExportFlow::draw_work() {
    if (const auto ended = task_.poll()) {
        problem_ = ended->problem;
        step_ = problem_.empty() ? Step::none : Step::problem;
        if (step_ == Step::problem) return {};
        if (ended->message.empty()) return "The export was stopped";
        const fs::path folder = extension_of(dialog_.chosen).empty() ? output_ : output_.parent_path();
        report_ = ui::ExportReport{
            .title = ended->message, .folder = folder.string(), .notes = written_->notes, .steps = steps()};
        for (const fs::path& file : written_->files) report_->files.push_back(file.filename().string());
        opener_.forget_problem();
        return ended->message;
    }
    if (ui::progress_dialog("Exporting", output_.filename().string(), task_.progress())) task_.cancel();
    return {};
}

std::vector<std::string> ExportFlow::steps() const {
    return is_picture(dialog_.chosen)
               ? next_steps(picture_format(dialog_.chosen).next, {}, output_)
               : next_steps(*export_formats()[dialog_.chosen], dialog_.prefix, output_);
}

void ExportFlow::draw_report() {
    if (!report_) return;
    report_->problem = opener_.problem();
    const ui::ReportAnswer answer = ui::export_report(*report_);
    if (answer == ui::ReportAnswer::open_folder) opener_.open(report_->folder, opener_program_);
    if (answer == ui::ReportAnswer::closed) report_.reset();
}

std::optional<std::string> ExportFlow::draw(const Document& document, PreviewPane& preview,
                                            const Scene& scene) {
    switch (step_) {
        case Step::none:
            break;
        case Step::options:
            draw_options(document);
            break;
        case Step::file:
            draw_file(document, preview, scene);
            break;
        case Step::replace:
            draw_question(document, preview, scene);
            break;
        case Step::work:
            return draw_work();
        case Step::problem:
            if (ui::question("Cannot export", problem_, {"OK"})) step_ = Step::none;
            break;
    }
    return {};
}

}  // namespace nacre
