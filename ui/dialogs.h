// Questions and file choices inside the window. The directory is read by the caller's function.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace nacre::ui {

struct DirectoryEntry {
    std::string name;
    bool is_directory = false;
};

struct Listing {
    std::filesystem::path directory;  // absolute
    std::vector<DirectoryEntry> entries;
    std::string problem;  // why it could not be read, or empty
};

using ListDirectory = std::function<Listing(const std::filesystem::path&)>;

// A dialog is open for as long as this value lives.
struct FileDialog {
    enum class Purpose { open, save, folder };
    Purpose purpose = Purpose::open;
    Listing listing;
    std::string path;     // as typed: absolute, or relative to the listing
    std::string problem;  // shown below the field
    bool take_focus = true;
    std::string title = "Files";
    std::string hint = "name or path of a file";
};

enum class DialogAnswer { none, accepted, cancelled };

// While accepted, `chosen` holds an absolute path. A typed folder is entered instead of accepted, and where a
// folder is asked for the one that is shown is accepted while nothing is typed.
DialogAnswer file_dialog(FileDialog& dialog, const ListDirectory& list, std::filesystem::path& chosen);

// A modal window in the middle, `ems` text sizes wide and as high as what it holds. Where this returns true
// end_dialog() follows, which closes it where `done`.
bool begin_dialog(const char* title, float ems);
void end_dialog(bool done);

// While something is waited for. Returns whether it is given up, by the button or by Escape.
bool waiting_dialog(const char* title, const std::string& text);

// A modal question; returns the index of the pressed button. Escape presses the last one, Enter the first,
// but while a number is typed into one of the `fields`, which stand between the text and the buttons.
std::optional<int> question(const char* title, const std::string& text,
                            const std::vector<std::string>& buttons,
                            const std::function<void()>& fields = {});

}  // namespace nacre::ui
