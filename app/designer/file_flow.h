// Opening and saving as a conversation: the question before work is lost, the file dialogs, the
// question before a file is overwritten.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/designer/autosave.h"
#include "app/designer/document.h"
#include "app/designer/file_chooser.h"
#include "app/designer/recent_files.h"
#include "app/designer/settings.h"

namespace nacre {

class FileFlow {
  public:
    // Each begins a conversation; it goes on in draw().
    void start_new(Document& document);
    void start_open(Document& document);
    void open_file(Document& document, const std::filesystem::path& file);
    // A preset becomes a new document, in one step of undo.
    void take_preset(Document& document, const std::filesystem::path& file);
    // Work of another process: the document becomes it once what is unsaved may go, and take_restored() hands
    // it out.
    void restore(Document& document, RecoveredWork found);
    // Asks first where the file holds something else than the document knows of.
    void save(Document& document);
    void save_as(const Document& document);
    // The document's file was seen to hold this instead; nothing where it is gone.
    void notice(const std::optional<FileContent>& now) { changed_ = Changed{.now = now}; }
    void quit(Document& document);

    // What the conversation reads and remembers between runs; both outlive it.
    struct Memory {
        Settings* settings;
        RecentFiles* recent;
        std::optional<DialogProgram> dialogs;  // as the settings allow
        std::filesystem::path home;
        std::function<std::vector<std::filesystem::path>()> inputs;  // never written: see output_guard.h
    };
    void remember(Memory memory) { memory_ = std::move(memory); }

    // Draws what is open and acts on the answers.
    void draw(Document& document);

    bool may_quit() const { return may_quit_; }
    bool talking() const {
        return asking_unsaved_ || asking_elsewhere_ || chooser_.open() || overwrite_ || changed_ ||
               !problem_.empty();
    }
    bool has_answer() const { return chooser_.has_answer(); }
    const std::string& message() const { return message_; }  // the last thing done
    const std::string& problem() const { return problem_; }  // shown until it is read
    void tell(std::string message) { message_ = std::move(message); }
    void report(std::string problem) { problem_ = std::move(problem); }

    // Where dialogs begin: beside the document, else where the last design was.
    std::filesystem::path folder(const Document& document) const;

    // The restored work that the document has just become, once.
    std::optional<RecoveredWork> take_restored() { return std::exchange(restored_, std::nullopt); }

  private:
    enum class Next { nothing, begin_new, show_open, open, restore, quit };

    void lose_work_for(Next next, Document& document);
    void go_on(Document& document);
    void load(Document& document);
    void become_restored(Document& document);
    bool may_write(const std::filesystem::path& file);
    void write(Document& document, const std::filesystem::path& file);
    void reload(Document& document);
    void note(const std::filesystem::path& file);
    void draw_dialog(Document& document);
    void draw_unsaved_question(Document& document);
    void draw_elsewhere_question(Document& document);
    void ask_elsewhere(Document& document);
    void draw_changed_question(Document& document);
    void draw_questions(Document& document);

    Memory memory_{};
    Next next_ = Next::nothing;  // once the present design may go
    std::filesystem::path to_open_;
    std::optional<RecoveredWork> to_restore_, restored_;
    bool asking_unsaved_ = false, asking_elsewhere_ = false;
    FileChooser chooser_;
    bool saving_ = false;  // what the chooser was asked for
    std::optional<std::filesystem::path> overwrite_;
    struct Changed {
        std::optional<FileContent> now;  // of the document's file; none where it is gone
        bool saving = false;             // else it was only noticed
    };
    std::optional<Changed> changed_;
    std::string problem_;
    std::string message_;
    bool may_quit_ = false;
};

}  // namespace nacre
