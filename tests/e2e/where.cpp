// nacre-where [--design FILE] [--script FILE] NAME...: left, top, right and bottom of each named widget in
// a window of 1280 x 800, from the designer without a window. The test of the real window points there.
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "app/headless/stage.h"
#include "core/base/input_file.h"
#include "core/design/design_file.h"

namespace {

void print_places(const std::vector<std::string>& arguments) {
    nacre::HeadlessDesigner stage({});
    stage.frame(false);
    stage.frame(false);
    std::size_t i = 0;
    for (; i + 1 < arguments.size() && arguments[i].starts_with("--"); i += 2) {
        const std::string& file = arguments[i + 1];
        if (arguments[i] == "--design")
            stage.designer().document = nacre::Document(nacre::load_design(file), file);
        else
            stage.play(nacre::parse_events(nacre::read_text_file(file), file));
    }
    stage.frame(false);
    for (; i < arguments.size(); ++i) {
        const auto box = stage.items().rectangle(arguments[i]);
        if (!box) throw std::runtime_error("no widget is called " + arguments[i]);
        std::printf("%.0f %.0f %.0f %.0f\n", static_cast<double>(box->x), static_cast<double>(box->y),
                    static_cast<double>(box->z), static_cast<double>(box->w));
    }
}

}  // namespace

int main(int count, char** values) {
    try {
        print_places({values + 1, values + count});
    } catch (const std::exception& error) {
        std::fprintf(stderr, "nacre-where: %s\n", error.what());
        return 1;
    }
    return 0;
}
