#include "app/designer/past.h"

#include <vector>

#include "ui/history_panel.h"

namespace nacre {

void draw_history(Document& document) {
    const History& history = document.history;
    std::vector<ui::HistoryRow> rows;
    for (const History::State& state : history.states())
        rows.push_back({.what = state.what, .later = rows.size() > history.position()});
    if (const auto clicked = ui::history_panel(rows, history.position()))
        document.go_to(history.states()[*clicked].number);
}

}  // namespace nacre
