// Exporting as a conversation: the format and its options, the file, the question before something is
// replaced, the work with its progress.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/designer/background_task.h"
#include "app/designer/document.h"
#include "app/designer/file_chooser.h"
#include "app/designer/folder_opener.h"
#include "app/designer/preview_pane.h"
#include "app/designer/settings.h"
#include "ui/export_dialog.h"
#include "ui/export_report.h"

namespace nacre {

class ExportFlow {
  public:
    // `folder_opener`: as find_folder_opener() gives it.
    explicit ExportFlow(std::filesystem::path folder_opener);

    void start() {
        step_ = Step::options;
        held_ = false;
        report_.reset();
    }
    // `inputs`: what is never written, see output_guard.h.
    void remember(Settings* settings, const std::optional<DialogProgram>& dialogs,
                  std::function<std::vector<std::filesystem::path>()> inputs) {
        settings_ = settings;
        dialogs_ = dialogs;
        inputs_ = std::move(inputs);
    }

    // Draws what is open and acts on the answers. Returns what is to be told.
    std::optional<std::string> draw(const Document& document, PreviewPane& preview, const Scene& scene);

    // What was written last and what to do next with it, over the rest of the window, until it is closed.
    void draw_report();
    const std::optional<ui::ExportReport>& report() const { return report_; }

    bool talking() const { return step_ != Step::none; }
    bool in_motion() const { return task_.busy() || chooser_.has_answer(); }
    ui::ExportDialog& options() { return dialog_; }
    const std::string& problem() const { return problem_; }

  private:
    enum class Step { none, options, file, replace, work, problem };

    void draw_options(const Document& document);
    void tell_holdings(const Design& design);
    void ask_file(const Document& document);
    void draw_file(const Document& document, PreviewPane& preview, const Scene& scene);
    void draw_question(const Document& document, PreviewPane& preview, const Scene& scene);
    bool may_write(const Design& design);
    void begin(const Document& document, PreviewPane& preview, const Scene& scene);
    void start_work(const Document& document, PreviewPane& preview, const Scene& scene);
    std::optional<std::string> draw_work();
    std::vector<std::string> steps() const;

    Settings* settings_ = nullptr;
    std::optional<DialogProgram> dialogs_;
    std::function<std::vector<std::filesystem::path>()> inputs_;
    Step step_ = Step::none;
    ui::ExportDialog dialog_;
    bool held_ = false;  // the dialog says what each format holds of the design
    FileChooser chooser_;
    std::filesystem::path output_;
    BackgroundTask task_;
    struct Written {
        std::vector<std::filesystem::path> files;
        std::vector<std::string> notes;
    };
    std::shared_ptr<Written> written_;  // by the task
    std::optional<ui::ExportReport> report_;
    std::filesystem::path opener_program_;
    FolderOpener opener_;
    std::string problem_;
};

}  // namespace nacre
