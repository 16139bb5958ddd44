#include "core/study/paper_page.h"

#include <fmt/core.h>

#include "core/base/file_extension.h"
#include "core/base/xml_text.h"

namespace nacre {
namespace {

constexpr const char* style = R"(
:root { color-scheme: light dark; --ink: #1f2328; --quiet: #5b636d; --line: #d9dde2; --ground: #fbfaf7; --card: #fff; --mark: #8a6d3b; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e4e3df; --quiet: #a3a7ad; --line: #3a3d42; --ground: #17181a; --card: #1f2123; --mark: #d3b072; }
}
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1.5rem 1rem 4rem; max-width: 62rem; background: var(--ground); color: var(--ink);
  font: 1rem/1.55 Inter, 'Helvetica Neue', Helvetica, Arial, 'DejaVu Sans', sans-serif; }
h1 { font-size: 1.7rem; line-height: 1.25; margin: 0 0 .5rem; }
h2 { font-size: 1.25rem; line-height: 1.3; margin: 0 0 .8rem; }
a { color: inherit; }
nav { display: flex; flex-wrap: wrap; gap: .3rem 1rem; margin: 1rem 0 0; font-size: .92rem; }
section { margin-top: 2.2rem; padding-top: 1.6rem; border-top: 1px solid var(--line); }
blockquote { margin: 0 0 1.1rem; padding: .1rem 0 .1rem .9rem; border-left: 3px solid var(--mark); color: var(--quiet); }
blockquote cite { display: block; font-style: normal; font-size: .88rem; margin-top: .25rem; }
.row { display: flex; flex-wrap: wrap; gap: 1rem; }
figure { margin: 0; flex: 1 1 15rem; min-width: 0; }
figure.plot { flex: 1 1 34rem; max-width: 46rem; overflow-x: auto; }
figure img { display: block; width: 100%; height: auto; border-radius: 6px; }
figure.plot img { min-width: 34rem; background: #fff; border: 1px solid var(--line); }
figcaption { margin-top: .35rem; font-size: .9rem; color: var(--quiet); }
.scroll { overflow-x: auto; margin-top: 1.1rem; }
table { border-collapse: collapse; font-size: .92rem; font-variant-numeric: tabular-nums; }
th, td { padding: .3rem .9rem .3rem 0; text-align: left; border-bottom: 1px solid var(--line); }
th { font-weight: 600; }
p { margin: .9rem 0 0; max-width: 46rem; }
)";

bool is_plot(const PaperPicture& picture) { return extension_of(picture.file) == ".svg"; }

std::string figure_text(const PaperPicture& picture) {
    const std::string file = xml_text(picture.file), caption = xml_text(picture.caption);
    return fmt::format(
        "<figure{0}><a href=\"{1}\"><img src=\"{1}\" alt=\"{2}\"></a><figcaption>{2}</figcaption></figure>\n",
        is_plot(picture) ? " class=\"plot\"" : "", file, caption);
}

std::string row_text(const std::vector<std::string>& cells, const char* tag) {
    std::string text = "<tr>";
    for (const std::string& cell : cells) text += fmt::format("<{0}>{1}</{0}>", tag, xml_text(cell));
    return text + "</tr>\n";
}

std::string table_text(const PaperTable& table) {
    std::string text = "<div class=\"scroll\"><table>\n" + row_text(table.head, "th");
    for (const std::vector<std::string>& row : table.rows) text += row_text(row, "td");
    return text + "</table></div>\n";
}

std::string section_text(const MadePart& made) {
    const PaperPart& part = *made.part;
    std::string text = fmt::format(
        "<section id=\"{}\">\n<h2>{}</h2>\n<blockquote>\u201c{}\u201d<cite>the paper, "
        "{}</cite></blockquote>\n",
        part.name, xml_text(part.title), xml_text(part.says), xml_text(part.where));
    if (!made.result.pictures.empty()) {
        text += "<div class=\"row\">\n";
        for (const PaperPicture& picture : made.result.pictures) text += figure_text(picture);
        text += "</div>\n";
    }
    for (const PaperTable& table : made.result.tables) text += table_text(table);
    for (const std::string& remark : made.result.remarks)
        text += fmt::format("<p>{}</p>\n", xml_text(remark));
    return text + "</section>\n";
}

}  // namespace

std::string paper_page(const std::vector<MadePart>& parts) {
    std::string text = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>A microfacet-based BRDF generator, made again</title>\n<style>{}</style>\n</head>\n<body>\n"
        "<h1>A microfacet-based BRDF generator, made again</h1>\n"
        "<p>The figures and numbers of Ashikhmin, Premo\u017ee and Shirley, SIGGRAPH 2000, by Nacre: each "
        "beside "
        "what the paper says of it, in its own words, and where this differs. The pictures have one small, "
        "distant "
        "light, as the paper's.</p>\n<nav>\n",
        style);
    for (const MadePart& made : parts)
        text += fmt::format("<a href=\"#{}\">{}</a>\n", made.part->name, xml_text(made.part->title));
    text += "</nav>\n";
    for (const MadePart& made : parts) text += section_text(made);
    return text + "</body>\n</html>\n";
}

}  // namespace nacre
