// The design that is being edited, its history and its file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/base/system/file_content.h"
#include "core/design/history.h"

namespace nacre {

// What a new document begins with: red lacquer, on which every slider shows.
Design starter_design();

struct Document {
    History history;
    Design design;                 // as on the screen; differs from history.current() only during an edit
    std::string doing = "Edit";    // what the present edit is called, for the history
    std::filesystem::path file;    // empty before the first save
    std::filesystem::path preset;  // that it began as, or empty
    // What the file and the pictures that the design refers to held when they were last read, written, or
    // left as they are by the user's own word.
    HeldFiles held;

    // `what`: how the history calls it; without one, by the file.
    explicit Document(Design start = starter_design(), std::filesystem::path from = {},
                      const std::string& what = {});

    // Differs from that of every other document, however it came: opened, begun, or by undo.
    std::pair<std::uint64_t, int> identity() const { return {serial_, history.document()}; }

    // From now on it differs from what is on the disk, whatever it is.
    void mark_unsaved() { history.mark_unsaved(); }

    // Another document takes the place of this one, in one step of undo that brings this one back with its
    // file. `what`: how the history calls it.
    void begin(const Document& other, const std::string& what);

    // The design that stands in the file now takes the place of this one, in one step of undo.
    void reload(const Document& read);

    // What the file holds now, if it is there, is known, and is not asked about again until it changes once
    // more.
    void keep_mine(const std::optional<FileContent>& now);

    // Ends the present edit: one step of undo, if anything changed.
    void commit();
    void undo();
    void redo();
    // Undoes or redoes until the history's state of this number is the current one.
    void go_to(std::uint64_t number);
    bool unsaved() const { return !history.saved() || design != history.current(); }

    // Work that is not saved: of this document as its newest step has it, or of one whose place another took.
    struct Unsaved {
        int document;  // as the history numbers it
        const Design* design;
        std::filesystem::path file;
        HeldFiles held;
    };
    std::vector<Unsaved> unsaved_elsewhere() const;  // the newest first
    std::vector<Unsaved> all_unsaved() const;        // this one first
    void go_elsewhere();  // undoes or redoes until the newest of the others is the document

    // What files made of it are named by: the file's name without its end, else the design's in small
    // letters.
    std::string stem() const;

    // "Satin \u2013 satin.nacre", with a dot before it while unsaved.
    std::string title() const;

  private:
    struct Origin {
        std::filesystem::path file, preset;
        HeldFiles held;
    };
    void follow_history(int before);

    std::uint64_t serial_;
    std::map<int, Origin> origins_;  // of the documents that history holds, but for the current one
};

// What is wrong with the file or a picture is a UserError.
Document read_document(const std::filesystem::path& file);

}  // namespace nacre
