#include "ui/plot_pen.h"

#include <cmath>
#include <vector>

#include "ui/theme.h"

namespace nacre::ui {
namespace {

constexpr float text_part = 0.87f;  // of the panels' text

ImVec2 screen(glm::dvec2 at) { return {static_cast<float>(at.x), static_cast<float>(at.y)}; }

// On a dark ground. The azimuths': Okabe & Ito (2008), the dark ones lightened.
Colour colour_of(Ink ink) {
    switch (ink) {
        case Ink::text:
            return palette::text;
        case Ink::quiet:
            return palette::text_dim;
        case Ink::grid:
            return {1, 1, 1, 0.09f};
        case Ink::plain:
            return palette::accent_bright;
        case Ink::red:
            return {0.97f, 0.45f, 0.40f, 1};
        case Ink::green:
            return {0.50f, 0.83f, 0.47f, 1};
        case Ink::blue:
            return {0.45f, 0.66f, 0.99f, 1};
        case Ink::first:
            return {0.34f, 0.71f, 0.91f, 1};
        case Ink::second:
            return {0.95f, 0.66f, 0.10f, 1};
        case Ink::third:
            return {0.16f, 0.76f, 0.57f, 1};
        case Ink::fourth:
            return {0.88f, 0.56f, 0.73f, 1};
    }
    return palette::text;
}

}  // namespace

PlotPenOnScreen::PlotPenOnScreen(ImTextureID picture)
    : list_(*ImGui::GetWindowDrawList()),
      picture_(picture),
      size_(std::round(text_part * ImGui::GetFontSize())) {}

double PlotPenOnScreen::em() const { return static_cast<double>(size_); }

double PlotPenOnScreen::text_width(const std::string& text) const {
    return static_cast<double>(ImGui::GetFont()->CalcTextSizeA(size_, FLT_MAX, 0, text.c_str()).x);
}

void PlotPenOnScreen::text(glm::dvec2 left_middle, const std::string& text, Ink ink) {
    const ImVec2 middle = screen(left_middle);
    list_.AddText(ImGui::GetFont(), size_, {std::round(middle.x), std::round(middle.y - 0.5f * size_)},
                  ImGui::GetColorU32(colour_of(ink)), text.c_str());
}

void PlotPenOnScreen::line(std::span<const glm::dvec2> points, Ink ink, double width) {
    std::vector<ImVec2> places;
    places.reserve(points.size());
    for (const glm::dvec2& point : points) places.push_back(screen(point));
    list_.AddPolyline(places.data(), static_cast<int>(places.size()), ImGui::GetColorU32(colour_of(ink)), 0,
                      static_cast<float>(width));
}

void PlotPenOnScreen::disc(glm::dvec2 middle, double radius, Ink ink) {
    list_.AddCircleFilled(screen(middle), static_cast<float>(radius), ImGui::GetColorU32(colour_of(ink)));
}

void PlotPenOnScreen::mesh(std::span<const glm::dvec2> corners, std::span<const glm::u8vec3> colours,
                           std::span<const Cell> cells) {
    const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
    list_.PrimReserve(static_cast<int>(6 * cells.size()), static_cast<int>(corners.size()));
    const unsigned int first = list_._VtxCurrentIdx;
    for (const Cell& cell : cells)
        for (const std::size_t corner : {0, 1, 2, 0, 2, 3})
            list_.PrimWriteIdx(static_cast<ImDrawIdx>(first + cell[corner]));
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const glm::u8vec3& c = colours[i];
        list_.PrimWriteVtx(screen(corners[i]), white, IM_COL32(c.x, c.y, c.z, 255));
    }
}

void PlotPenOnScreen::picture(const PlotBox& box, const SlicePlot& slice) {
    if (picture_ == nullptr) return;
    const float half = 0.5f / static_cast<float>(slice.side);
    list_.AddImage(picture_, screen(box.low), screen(box.high), {half, half}, {1 - half, 1 - half});
}

}  // namespace nacre::ui
