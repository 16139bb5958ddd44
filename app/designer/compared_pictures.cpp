#include "app/designer/compared_pictures.h"

#include <cstdint>
#include <vector>

namespace nacre {
namespace {

ImTextureID handle(GLuint texture) {
    return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture));
}

}  // namespace

void ComparedPictures::show(int side, const std::optional<ComparedSurface>& surface) {
    own_[side] = surface.has_value();
    if (!surface) return;
    if (!sides_[side]) sides_[side] = std::make_unique<Preview>();
    sides_[side]->set(surface->tables, surface->model);
}

std::vector<Preview*> ComparedPictures::shown(Preview& now, const CompareLook& look) const {
    if (!look.compares()) return {&now};
    std::vector<Preview*> previews;
    if (!own_[0] || !own_[1]) previews.push_back(&now);
    for (int i = 0; i < 2; ++i)
        if (own_[i]) previews.push_back(sides_[i].get());
    return previews;
}

void ComparedPictures::share_scale(Preview& now, const Scene& scene, const CompareLook& look) {
    std::optional<FactorScale> scale;
    if (look.compares() && is_factor(scene.term))
        scale = common_scale(side(0, now).scale(scene), side(1, now).scale(scene));
    now.use_scale(scale);
    for (Preview* preview : shown(now, look)) preview->use_scale(scale);
}

void ComparedPictures::draw(Preview& now, const Scene& scene, glm::ivec2 texels, int supersample,
                            const CompareLook& look) {
    share_scale(now, scene, look);
    for (Preview* preview : shown(now, look)) preview->draw(scene, texels, supersample);
    if (look.view == ui::CompareView::difference) draw_difference(now, scene, texels, look.difference);
}

void ComparedPictures::begin(Preview& now, const Scene& scene, glm::ivec2 texels, int supersample, int goal,
                             const CompareLook& look) {
    share_scale(now, scene, look);
    begun_scene_ = scene;
    begun_texels_ = texels;
    for (Preview* preview : shown(now, look)) preview->begin(scene, texels, supersample, goal);
}

void ComparedPictures::refine(Preview& now, double seconds, const CompareLook& look) {
    const SampleProgress before = progress(now, look);
    if (before.samples >= before.goal) return;
    const std::vector<Preview*> previews = shown(now, look);
    for (Preview* preview : previews) preview->refine(seconds / static_cast<double>(previews.size()));
    if (look.view == ui::CompareView::difference && progress(now, look).samples > 0)
        draw_difference(now, begun_scene_, begun_texels_, look.difference);
}

SampleProgress ComparedPictures::progress(const Preview& now, const CompareLook& look) const {
    if (!look.compares()) return now.progress();
    const SampleProgress left = side(0, now).progress(), right = side(1, now).progress();
    return left.samples < right.samples ? left : right;
}

void ComparedPictures::draw_difference(Preview& now, const Scene& scene, glm::ivec2 texels,
                                       const DifferenceLook& look) {
    const std::vector<float> left = side(0, now).numbers();
    const std::vector<float> right = side(1, now).numbers();
    // The present design's own is kept at the size of the window, for the pointer.
    const SurfaceImage& object = side(own_[0] ? 0 : 1, now).surface(scene, texels);
    numbers_ = measure_difference(left, right, 4, [&](std::size_t pixel) {
        const auto width = static_cast<std::size_t>(texels.x);
        return object.covered(
            {static_cast<int>(pixel % width), texels.y - 1 - static_cast<int>(pixel / width)});
    });
    const std::vector<float> rgb = difference_picture(left, right, 4, look);
    difference_.store(texels, GL_RGB8, GL_RGB, GL_FLOAT, rgb.data(), GL_LINEAR);
}

void ComparedPictures::paint(const Preview& now, const CompareLook& look, ImVec2 corner, ImVec2 size) const {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end(corner.x + size.x, corner.y + size.y);
    if (look.alone || look.view == ui::CompareView::off)
        return list.AddImage(handle((look.alone ? side(*look.alone, now) : now).texture()), corner, end,
                             ImVec2(0, 1), ImVec2(1, 0));
    if (look.view == ui::CompareView::difference)
        return list.AddImage(handle(difference_.name()), corner, end, ImVec2(0, 1), ImVec2(1, 0));
    const auto part = static_cast<float>(look.divider);
    const float x = corner.x + part * size.x;
    list.AddImage(handle(side(0, now).texture()), corner, {x, end.y}, ImVec2(0, 1), ImVec2(part, 0));
    list.AddImage(handle(side(1, now).texture()), {x, corner.y}, end, ImVec2(part, 1), ImVec2(1, 0));
}

}  // namespace nacre
