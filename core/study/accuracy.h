// Error against time of every method of computing and storing g and R, measured on one design.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/bake/tables.h"
#include "core/design/design.h"
#include "core/study/method.h"
#include "core/study/omission_cost.h"

namespace nacre {

enum class Quantity {
    area,       // g; error relative, see area_error()
    albedo_f1,  // R with F = 1; absolute
    albedo_f0   // R with Schlick's factor of f0 = 0; absolute
};

const char* name_of(Quantity quantity);  // g, R1, R0

struct AccuracyPoint {
    std::string setting;
    Quantity quantity = Quantity::area;
    double seconds = 0;     // of the processor, from the design to the table: the shortest of several runs
    std::size_t bytes = 0;  // of all that is stored; with R, g is among it
    TableError error;
};

struct MethodAccuracy {
    MethodKind kind;
    std::string name;
    std::string about;
    std::vector<AccuracyPoint> points;  // in the order they were made, rising in cost
    std::string left_out;               // why there are none
};

struct DesignAccuracy {
    std::string name;         // of the design, for people
    std::string file;         // stem for the files about it
    std::string energy_note;  // see core/design/design_check.h
    Symmetry symmetry = Symmetry::none;
    std::vector<MethodAccuracy> methods;
    OmissionCosts costs;
};

struct AccuracyOptions {
    int area_probes = 200;
    int albedo_probes = 16;
    double longest = 1;  // seconds: a method goes on to no larger table after one that took longer
};

// R is that of the design's p and shadowing, with F = 1 and with f0 = 0 whatever its own Fresnel model is,
// and without the layers' tints. Throws what bake() throws; BakeCancelled soon after `stop` is requested.
// `progress` gets values in [0, 1].
DesignAccuracy measure_accuracy(const Design& design, const AccuracyOptions& options = {},
                                std::stop_token stop = {}, const std::function<void(double)>& progress = {});

}  // namespace nacre
