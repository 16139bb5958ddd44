// XML without a parser of XML.
#pragma once

#include <string>
#include <vector>

namespace nacre::test {

// Tags are closed in order, attributes quoted, and nothing else in the text is markup.
inline bool is_well_formed(const std::string& xml) {
    std::vector<std::string> open;
    bool had_root = false;
    for (std::size_t i = 0; i < xml.size();) {
        if (xml[i] == '>') return false;
        if (xml[i] == '&') {
            const std::string entity = xml.substr(i, xml.find(';', i) - i);
            if (entity != "&amp" && entity != "&lt" && entity != "&gt" && entity != "&quot") return false;
        }
        if (xml[i] != '<') {
            ++i;
            continue;
        }
        std::size_t end = i;
        for (bool quoted = false; end < xml.size() && (quoted || xml[end] != '>'); ++end) {
            if (end > i && xml[end] == '<') return false;
            if (xml[end] == '"') quoted = !quoted;
        }
        if (end == xml.size()) return false;
        const std::string tag = xml.substr(i + 1, end - i - 1);
        i = end + 1;
        if (tag.starts_with('?')) continue;
        const std::string name = tag.substr(0, tag.find_first_of(" /"));
        if (tag.starts_with('/')) {
            if (open.empty() || open.back() != tag.substr(1)) return false;
            open.pop_back();
        } else {
            if (open.empty() && had_root) return false;
            had_root = true;
            if (!tag.ends_with('/')) open.push_back(name);
        }
    }
    return had_root && open.empty();
}

}  // namespace nacre::test
