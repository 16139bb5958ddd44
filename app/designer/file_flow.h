// Opening and saving as a conversation: the question before work is lost, the file dialogs, the
// question before a file is overwritten.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/designer/document.h"
#include "ui/dialogs.h"

namespace nacre {

class FileFlow {
  public:
    // Each begins a conversation; it goes on in draw().
    void start_new(Document& document);
    void start_open(Document& document);
    void open_file(Document& document, const std::filesystem::path& file);
    void open_preset(Document& document, const std::filesystem::path& file);
    void save(Document& document);
    void save_as(const Document& document);
    void quit(Document& document);

    // Draws what is open and acts on the answers.
    void draw(Document& document);

    bool may_quit() const { return may_quit_; }
    bool talking() const { return asking_unsaved_ || dialog_ || overwrite_ || !problem_.empty(); }
    const std::string& message() const { return message_; }  // the last thing done
    void tell(std::string message) { message_ = std::move(message); }

  private:
    enum class Next { nothing, begin_new, show_open, open, open_preset, quit };

    void lose_work_for(Next next, Document& document);
    void go_on(Document& document);
    void load(Document& document, bool as_preset);
    void write(Document& document, const std::filesystem::path& file);
    void draw_dialog(Document& document);
    void draw_questions(Document& document);

    Next next_ = Next::nothing;  // once the present design may go
    std::filesystem::path to_open_;
    bool asking_unsaved_ = false;
    std::optional<ui::FileDialog> dialog_;
    std::optional<std::filesystem::path> overwrite_;
    std::filesystem::path last_folder_;
    std::string problem_;
    std::string message_;
    bool may_quit_ = false;
};

}  // namespace nacre
