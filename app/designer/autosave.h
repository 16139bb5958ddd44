// Unsaved work, kept after each step of undo where the next start finds it. docs/document.md tells the
// format.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

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
    // Each process has a folder of its own below this one, made with its first write. Empty: nothing is kept.
    explicit Autosave(std::filesystem::path folder, std::uintmax_t bytes_max = autosave_bytes_max);

    // Once a frame: begins to write the document's newest step, or what another document took the place of
    // and is not saved, or to remove the file once there is nothing unsaved. Never waits.
    void follow(const Document& document);

    // Work of another process becomes this one's in a single step. Waits for the writer.
    void take_over(RecoveredWork found);

    // The clean end: the file goes, whatever is unsaved. Waits for the writer.
    void finish();

    // Why the newest write failed, in one line; empty when it did not.
    const std::string& problem() const { return problem_; }
    bool busy() const { return job_.busy(); }
    void wait() const { job_.wait(); }

    // Counts of what is to be kept and of what has been.
    std::uint64_t asked() const { return asked_; }
    std::uint64_t kept() const { return kept_; }

  private:
    using Wanted = std::optional<UnsavedWork>;  // none: no file
    void write(const Wanted& wanted);
    void make_folder();
    void submit(Wanted wanted);

    std::filesystem::path folder_;
    std::uintmax_t bytes_max_;
    std::optional<LockedDirectory> own_;  // only the worker uses it while it is busy
    Wanted wanted_;
    std::string problem_;
    std::uint64_t asked_ = 0, kept_ = 0;
    LatestJob<Wanted, bool> job_;
};

}  // namespace nacre
