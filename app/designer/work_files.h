// The files that the work came from and refers to: none is written over unasked, and none changes unnoticed.
#pragma once

#include "app/designer/designer.h"

namespace nacre {

// Hands the flows of files what they read and remember.
void prepare_dialogs(Designer& designer);

// Asks about what other programs have changed, one question after another, and only while nothing else is
// asked.
void follow_files(Designer& designer);

}  // namespace nacre
