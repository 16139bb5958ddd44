// A web page that shows the design.
#include "core/formats/export_format.h"
#include "core/formats/web_page.h"

namespace nacre {
namespace {

ExportWriter prepare(const Design& design, const ExportSettings& settings, const std::stop_token& stop,
                     const std::function<void(double)>& progress) {
    BakeOptions options = settings.bake;
    options.albedo = true;  // for ambient light
    WebPage page = make_web_page(design, *bake(design, options, stop, progress));
    ExportWriter writer(std::move(page.html));
    if (!page.remark.empty()) writer.notes.push_back(std::move(page.remark));
    return writer;
}

}  // namespace

const ExportFormat web_format{
    .name = "web",
    .title = "Web page",
    .about = "one HTML file that shows the design on a lit sphere, also without a network",
    .next =
        "Open {file} in a browser: a double click will do.\n"
        "Drag the sphere to turn it, and beside it to move the light; the wheel sets the exposure.\n"
        "Send {file} or put it on a web site as it is: it needs no other file.",
    .extension = ".html",
    .has_names = false,
    .has_error = false,
    .holds = Holdings(Holding::exact).but(Holding::fitted, {Feature::painted}),
    .files = one_file,
    .prepare = prepare};

}  // namespace nacre
