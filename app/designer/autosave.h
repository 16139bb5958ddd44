// Unsaved work, kept after each step of undo where the next start finds it. docs/document.md tells the
// format.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/designer/document.h"
#include "core/base/latest_job.h"
#include "core/base/system/locked_directory.h"

namespace nacre {

struct UnsavedWork {
    Design design;
    std::filesystem::path file;  // of the document; empty for one that was never saved
    HeldFiles held = {};         // as of the document
    bool operator==(const UnsavedWork&) const = default;
};

// What another process left behind, and where.
struct RecoveredWork {
    UnsavedWork work;
    LockedDirectory folder;
    std::size_t others = 0;  // works that were left behind beside it
};

// More than sixteen layers of painted and modulated facets take.
inline constexpr std::uintmax_t autosave_bytes_max = std::uintmax_t{1} << 30;

// The first line is JSON about the work, the rest is a design file. The pictures of the design are held in
// it, so that it needs no other file to be restored. What could not be read again, as more than `bytes_max`,
// is a UserError.
void write_autosave(const UnsavedWork& work, const std::filesystem::path& file,
                    std::uintmax_t bytes_max = autosave_bytes_max);

// Its first line alone.
struct AutosaveHead {
    std::string name;            // of the design
    std::filesystem::path file;  // of the document
};
AutosaveHead read_autosave_head(const std::filesystem::path& file);

// Whatever is wrong is a UserError about the file.
UnsavedWork read_autosave(const std::filesystem::path& file);
UnsavedWork parse_autosave(const std::string& text, const std::filesystem::path& file);

// Writes on a thread of its own, one file at a time; what is newest when a write ends is written next.
class Autosave {
  public:
    // Each work has a folder of its own below this one, made when it is first written. Empty: nothing is
    // kept.
    explicit Autosave(std::filesystem::path folder, std::uintmax_t bytes_max = autosave_bytes_max);

    // Once a frame: begins to write what is not saved of the document and of those whose place it took, and
    // to remove the files of what is saved or gone. Never waits.
    void follow(const Document& document);

    // Work of another process becomes this one's, as this document of the history, in a single step. Waits
    // for the writer.
    void take_over(RecoveredWork found, int document);

    // The clean end: the files go, whatever is unsaved. Waits for the writer.
    void finish();

    // Why the newest write failed, in one line; empty when it did not.
    const std::string& problem() const { return problem_; }
    bool busy() const { return job_.busy(); }
    void wait() const { job_.wait(); }

    // Counts of what is to be kept and of what has been.
    std::uint64_t asked() const { return asked_; }
    std::uint64_t kept() const { return kept_; }

  private:
    struct Wanted {
        int document = 0;          // as the history numbers it
        std::uint64_t number = 0;  // of no other state of any work, from 1
        UnsavedWork work;
    };
    // A folder, and what stands in its file.
    struct Place {
        LockedDirectory folder;
        std::optional<int> document;  // none: no file
        std::uint64_t number = 0;     // of the state that is written
    };
    void write(const std::vector<Wanted>& wanted);
    Place& place_of(int document);
    void clear_others(const std::vector<Wanted>& wanted);

    std::filesystem::path folder_;
    std::uintmax_t bytes_max_;
    std::vector<Place> places_;  // only the worker uses them while it is busy
    std::vector<Wanted> wanted_;
    std::uint64_t numbers_ = 0;  // given
    std::string problem_;
    std::uint64_t asked_ = 0, kept_ = 0;
    LatestJob<std::vector<Wanted>, bool> job_;
};

}  // namespace nacre
