// One line below the picture: what was baked and how well, or what is wrong.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace nacre::ui {

// What the shown tables are.
struct TablesStatus {
    std::string quality;
    std::string validity;  // of p
    bool valid = true;
    bool creates_energy = false;
    std::vector<std::string> left_out;
    std::string tables;  // size, time, errors
};

struct Status {
    std::optional<TablesStatus> baked;
    std::string message;  // the last thing that happened, for instance "Saved satin.nacre"
    std::string problem;  // in plain words; stands before everything else
    std::string warning;  // what should be known though the work goes on; in place of the message
    bool working = false;
    bool expert = true;   // says more of the tables than how far they are
    float kept_free = 0;  // width at the right end, pixels
};

float status_height();
void status_line(const Status& status);

}  // namespace nacre::ui
