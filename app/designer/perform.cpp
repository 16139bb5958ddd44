#include "app/designer/perform.h"

namespace nacre {

std::optional<DialogProgram> file_dialogs(const Designer& designer) {
    return designer.settings.values.system_dialogs ? designer.options.dialogs : std::nullopt;
}

void take_file(Designer& designer, const std::filesystem::path& file) {
    const bool is_picture = file.extension() != design_extension && !names_object(file.string());
    if (talking(designer) && !(is_picture && designer.pictures.choosing())) return;
    if (file.extension() == design_extension)
        designer.files.open_file(designer.document, file);
    else if (names_object(file.string()))
        designer.objects.want(file.string());
    else
        designer.pictures.offer(file);
}

}  // namespace nacre
