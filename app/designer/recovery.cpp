#include "app/designer/recovery.h"

#include <algorithm>
#include <cstdint>
#include <exception>
#include <utility>

#include "core/base/error.h"
#include "core/base/system/file_time.h"
#include "ui/recovery_dialog.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

struct Found {
    LostWork work;
    std::int64_t changed = 0;  // nanoseconds since 1970
};

// Nothing where the folder holds no work; it is removed then.
std::optional<Found> work_in(LockedDirectory folder) {
    const fs::path file = folder.file();
    const auto written = time_written(file);
    if (!written) {
        folder.erase();
        return {};
    }
    Found found{{std::move(folder), {}, {}, local_time(*written), {}}, *written};
    try {
        const AutosaveHead head = read_autosave_head(file);
        found.work.name = head.name;
        found.work.file = head.file;
    } catch (const std::exception&) {
        found.work.problem = problem_line();
    }
    return found;
}

}  // namespace

void Recovery::look() {
    lost_.clear();
    chosen_ = 0;
    if (folder_.empty()) return;
    std::vector<Found> all;
    for (LockedDirectory& orphan : claim_abandoned(folder_))
        if (auto found = work_in(std::move(orphan))) all.push_back(std::move(*found));
    std::sort(all.begin(), all.end(), [](const Found& a, const Found& b) { return a.changed > b.changed; });
    for (Found& found : all) lost_.push_back(std::move(found.work));
}

std::optional<RecoveredWork> Recovery::draw() {
    if (lost_.empty()) return {};
    std::vector<ui::RecoveryRow> rows;
    for (const LostWork& lost : lost_)
        rows.push_back({.name = lost.name.empty() ? "Untitled" : lost.name,
                        .where = !lost.problem.empty() ? lost.problem
                                 : lost.file.empty()   ? "never saved"
                                                       : lost.file.string(),
                        .when = lost.when});
    const auto answer = ui::recovery_dialog(rows, chosen_, problem_);
    if (!answer) return {};
    if (*answer == ui::RecoveryAnswer::later) {
        lost_.clear();
        return {};
    }
    const auto chosen = lost_.begin() + static_cast<std::ptrdiff_t>(chosen_);
    if (*answer == ui::RecoveryAnswer::discard) {
        chosen->folder.erase();
        lost_.erase(chosen);
        chosen_ = 0;
        problem_.clear();
        return {};
    }
    try {
        RecoveredWork restored{read_autosave(chosen->folder.file()), std::move(chosen->folder),
                               lost_.size() - 1};
        lost_.clear();
        problem_.clear();
        return restored;
    } catch (const std::exception&) {
        problem_ = problem_line();
        return {};
    }
}

std::optional<Document> saved_already(const UnsavedWork& work) {
    try {
        Document saved;
        if (!work.file.empty()) saved = read_document(work.file);
        return saved.file == work.file && saved.design == work.design ? std::optional(saved) : std::nullopt;
    } catch (const std::exception&) {
        return {};
    }
}

}  // namespace nacre
