#include <algorithm>

#include "app/designer/command.h"
#include "core/formats/export_format.h"

namespace nacre {

const Command share_page_command{
    .info = {.menu = "File",
             .label = "Share as a web page\u2026",
             .keys = nullptr,
             .about = "Write one HTML file that shows the design on a lit sphere in any browser."},
    .perform = [](Designer& designer, std::size_t) {
        const auto formats = export_formats();
        const auto page = std::find(formats.begin(), formats.end(), &web_format);
        designer.exporter.options().chosen = static_cast<std::size_t>(page - formats.begin());
        designer.exporter.start();
    }};

}  // namespace nacre
