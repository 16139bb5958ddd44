#include "core/study/accuracy_text.h"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "core/base/csv_field.h"
#include "core/base/error.h"
#include "core/formats/error_json.h"

namespace nacre {
namespace {

using Json = nlohmann::ordered_json;

Json points_json(const MethodAccuracy& method) {
    Json points = Json::array();
    for (const AccuracyPoint& point : method.points) {
        Json json = {{"setting", point.setting},
                     {"quantity", name_of(point.quantity)},
                     {"seconds", point.seconds},
                     {"bytes", point.bytes}};
        json.update(error_json(point.error));
        points.push_back(std::move(json));
    }
    return points;
}

Json cost_json(const BakeCost& cost) { return {{"seconds", cost.seconds}, {"bytes", cost.bytes}}; }

Json costs_json(const OmissionCosts& costs) {
    Json omissions = Json::array();
    for (const OmissionCost& cost : costs.omissions)
        omissions.push_back(
            {{"what", cost.omission.what}, {"why", cost.omission.why}, {"with_it", cost_json(cost.with_it)}});
    return {{"bake", cost_json(costs.bake)},
            {"left_out", std::move(omissions)},
            {"with_all", cost_json(costs.with_all)}};
}

Json design_json(const DesignAccuracy& design) {
    Json methods = Json::array();
    for (const MethodAccuracy& method : design.methods) {
        Json json = {{"name", method.name}, {"about", method.about}, {"points", points_json(method)}};
        if (!method.left_out.empty()) json["left_out"] = method.left_out;
        methods.push_back(std::move(json));
    }
    return {{"name", design.name},
            {"file", design.file},
            {"symmetry", name_of(design.symmetry)},
            {"ways", std::move(methods)},
            {"omissions", costs_json(design.costs)}};
}

}  // namespace

std::string accuracy_csv(const std::vector<DesignAccuracy>& designs) {
    std::string text = "design,file,symmetry,way,setting,quantity,seconds,bytes,worst,rms,directions\r\n";
    for (const DesignAccuracy& design : designs)
        for (const MethodAccuracy& method : design.methods)
            for (const AccuracyPoint& point : method.points)
                text += fmt::format(
                    "{},{},{},{},{},{},{:.6g},{},{:.6g},{:.6g},{}\r\n", csv_field(one_line(design.name)),
                    csv_field(one_line(design.file)), name_of(design.symmetry), csv_field(method.name),
                    csv_field(point.setting), name_of(point.quantity), point.seconds, point.bytes,
                    point.error.worst, point.error.root_mean_square, point.error.directions);
    return text;
}

std::string accuracy_json(const std::vector<DesignAccuracy>& designs) {
    Json list = Json::array();
    for (const DesignAccuracy& design : designs) list.push_back(design_json(design));
    const Json json = {
        {"report", "error beside time"},
        {"version", 1},
        {"quantities",
         {{"g", "|read - exact|/max(exact, q/20), both of G = max(g, N c) with clamp, of g without"},
          {"R1", "|read - exact|, F = 1"},
          {"R0", "|read - exact|, Schlick's factor of f0 = 0"}}},
        {"units",
         {{"seconds",
           "from the design to the table, one thread, the shortest of several runs; with R, g is among it"},
          {"bytes", "of all that is stored, 4 a number"}}},
        {"designs", std::move(list)}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace nacre
