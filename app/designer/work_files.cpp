#include "app/designer/work_files.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "app/designer/perform.h"
#include "core/design/picture_files.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

// The pictures of the design and those that layers were made from, the environment map and the object, where
// they came from files.
std::vector<fs::path> referred_files(const Designer& designer) {
    std::vector<fs::path> files = picture_files(designer.document.design);
    const std::vector<fs::path> sources = source_files(designer.document.design);
    files.insert(files.end(), sources.begin(), sources.end());
    for (const HeldFiles* held : {&designer.environment.held(), &designer.objects.held()})
        for (const auto& [file, content] : *held) files.push_back(file);
    return files;
}

// What the present work knows of its files.
HeldFiles watched_files(const Designer& designer) {
    HeldFiles watched;
    std::vector<fs::path> files = referred_files(designer);
    files.push_back(designer.document.file);
    for (const fs::path& file : files)
        for (const HeldFiles* held :
             {&designer.document.held, &designer.environment.held(), &designer.objects.held()})
            if (const auto content = content_in(*held, file)) watched[file] = *content;
    return watched;
}

}  // namespace

void prepare_dialogs(Designer& designer) {
    const auto dialogs = file_dialogs(designer);
    designer.files.remember({.settings = &designer.settings.values,
                             .recent = &designer.recent,
                             .dialogs = dialogs,
                             .home = designer.options.folders.home,
                             .inputs = [&designer] { return referred_files(designer); }});
    const auto inputs = [&designer] {
        std::vector<fs::path> files = referred_files(designer);
        files.push_back(designer.document.file);
        return files;
    };
    designer.exporter.remember(&designer.settings.values, dialogs, inputs);
    designer.plots.saving.remember(inputs);
    designer.pictures_of_preview.remember(&designer.settings.values, dialogs);
}

void follow_files(Designer& designer) {
    if (talking(designer)) return;
    auto changes = designer.watch.poll();
    if (!changes) return;
    const HeldFiles watched = watched_files(designer);
    std::erase_if(*changes, [&](const FileChange& change) {
        return content_in(watched, change.file) != change.before;  // read again meanwhile, or left
    });
    const auto own = std::find_if(changes->begin(), changes->end(), [&](const FileChange& change) {
        return change.file == designer.document.file;
    });
    if (own != changes->end()) {
        designer.files.notice(own->now);
        changes->erase(own);
    }
    designer.changed_pictures.notice(*std::move(changes));
}

void notice_focus(Designer& designer) {
    if (HeldFiles watched = watched_files(designer); !watched.empty())
        designer.watch.look(std::move(watched));
}

void open_at_start(Designer& designer, const fs::path& file) {
    prepare_dialogs(designer);
    designer.files.open_file(designer.document, file);
}

}  // namespace nacre
