#include "app/designer/command.h"

#include <array>

#include "ui/edit_name.h"

namespace nacre {

std::span<const Command* const> commands() {
    static const std::array list{
#define COMMAND(name) &name##_command,
#include "app/designer/command_list.inc"
#undef COMMAND
    };
    return list;
}

ui::CommandInfos command_infos() {
    static const std::vector<const ui::CommandInfo*> infos = [] {
        std::vector<const ui::CommandInfo*> list;
        for (const Command* command : commands()) list.push_back(&command->info);
        return list;
    }();
    return infos;
}

std::vector<ui::CommandState> command_states(const Designer& designer) {
    std::vector<ui::CommandState> states;
    for (const Command* command : commands()) {
        ui::CommandState state{.info = &command->info};
        if (command->enabled != nullptr) state.enabled = command->enabled(designer);
        if (command->checked != nullptr) state.checked = command->checked(designer);
        if (command->choices != nullptr) state.choices = command->choices(designer);
        states.push_back(std::move(state));
    }
    return states;
}

void perform(Designer& designer, const Command& command, std::size_t which) {
    if (talking(designer) || (command.enabled != nullptr && !command.enabled(designer))) return;
    designer.document.commit();  // what was being edited is a step of its own
    if (command.info.label != nullptr) ui::name_edit(command.info.label);
    command.perform(designer, which);
}

void perform(Designer& designer, const ui::Order& order) {
    perform(designer, *commands()[order.command], order.which);
}

}  // namespace nacre
