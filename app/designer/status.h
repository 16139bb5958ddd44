// Tables in a few words for the status line.
#pragma once

#include "core/bake/tables.h"
#include "ui/status_line.h"

namespace nacre {

ui::TablesStatus status_of(const Tables& tables);

}  // namespace nacre
