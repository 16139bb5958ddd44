// Escape closes what is on top, one thing for each press: a text that is typed, a drag, a list or menu, then
// a dialog. Whoever acts on it takes it, and nothing beneath sees it.
#pragma once

namespace nacre::ui {

// Whether Escape went down in this frame and nobody has taken it. A text field that has the keyboard takes
// it.
bool escape_pressed();

// The same, and from now on it is taken.
bool take_escape();

// Of the item that the mouse holds and of nothing else: lets it go.
bool take_escape_of_drag();

// Whether a drag was taken back in this frame, by whoever.
bool drag_taken_back();

// At the beginning of a frame: closes the topmost list, menu or popup that is no dialog, if Escape is for it.
void close_popup_by_escape();

}  // namespace nacre::ui
