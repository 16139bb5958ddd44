#include "app/cli/output_names.h"

#include <fmt/core.h>

#include <set>

#include "core/base/system/output_guard.h"

namespace nacre::cli {

std::vector<std::string> distinct_names(const std::vector<std::string>& stems,
                                        const std::vector<std::string>& taken,
                                        const std::filesystem::path& folder) {
    const bool fold = ignores_case(folder);
    const auto key = [&](const std::string& name) { return fold ? without_case(name) : name; };
    std::set<std::string> used;
    for (const std::string& name : taken) used.insert(key(name));
    std::vector<std::string> names(stems.size());
    for (std::size_t i = 0; i < stems.size(); ++i)
        if (used.insert(key(stems[i])).second) names[i] = stems[i];
    for (std::size_t i = 0; i < stems.size(); ++i)
        for (int number = 2; names[i].empty(); ++number)
            if (const std::string name = fmt::format("{}-{}", stems[i], number);
                used.insert(key(name)).second)
                names[i] = name;
    return names;
}

}  // namespace nacre::cli
