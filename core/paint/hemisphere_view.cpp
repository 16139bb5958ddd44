#include "core/paint/hemisphere_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/model/disk.h"

namespace nacre {
namespace {

constexpr double degrees_per_pixel = 0.4;  // by which a drag turns the dome

constexpr double margin = 1.17;  // of the shown radius: room for the angles' numbers around it
constexpr double radians = std::numbers::pi / 180;
constexpr double nadir = std::numbers::sqrt2;  // radius of the whole sphere's disk

// Between a normal and where it is shown, both ways.
glm::dvec3 turned(const HemisphereCamera& camera, glm::dvec3 h) {
    return camera.highlight ? glm::dvec3(-h.x, -h.y, h.z) : h;
}

// A camera may not lose sight of what it shows.
void keep_in_sight(HemisphereCamera& camera) {
    camera.zoom = std::clamp(camera.zoom, zoom_min, zoom_max);
    const double reach = (camera.below && !camera.dome ? nadir : 1.0) * (1 - 1 / camera.zoom);
    const double length = glm::length(camera.centre);
    if (length > reach) camera.centre *= length > 0 ? reach / length : 0;
}

}  // namespace

glm::dmat3 to_view(double yaw, double pitch) {
    const double cy = std::cos(yaw * radians), sy = std::sin(yaw * radians);
    const double lean = (90 - pitch) * radians, cl = std::cos(lean), sl = std::sin(lean);
    const glm::dmat3 turn{{cy, sy, 0}, {-sy, cy, 0}, {0, 0, 1}};
    const glm::dmat3 tip{{1, 0, 0}, {0, cl, -sl}, {0, sl, cl}};
    return tip * turn;
}

HemisphereView::HemisphereView(const HemisphereCamera& camera, glm::dvec2 size)
    : camera_(camera), size_(size), to_view_(to_view(camera.yaw, camera.pitch)) {
    unit_ = std::max(std::min(size.x, size.y), 1.0) / (2 * margin * radius()) * camera.zoom;
}

double HemisphereView::radius() const { return camera_.below && !camera_.dome ? nadir : 1; }

glm::dvec2 HemisphereView::plane(glm::dvec2 pixel) const {
    const glm::dvec2 off = (pixel - 0.5 * size_) / unit_;
    return camera_.centre + glm::dvec2(off.x, -off.y);
}

std::optional<glm::dvec3> HemisphereView::direction(glm::dvec2 pixel) const {
    const auto at = shown(pixel);
    return at ? std::optional(turned(camera_, *at)) : at;
}

std::optional<glm::dvec3> HemisphereView::shown(glm::dvec2 pixel) const {
    const glm::dvec2 at = plane(pixel);
    const double r2 = glm::dot(at, at);
    if (!(r2 <= radius() * radius())) return {};
    if (!camera_.dome) return disk_direction(at);
    const double depth = std::sqrt(std::max(1 - r2, 0.0));
    const glm::dmat3 back = glm::transpose(to_view_);
    const glm::dvec3 front = back * glm::dvec3(at, depth);
    if (front.z >= 0 || camera_.below) return front;
    const glm::dvec3 inside = back * glm::dvec3(at, -depth);  // the hollow side of the dome
    if (inside.z >= 0) return inside;
    return {};
}

glm::dvec3 HemisphereView::nearest_direction(glm::dvec2 pixel) const {
    if (const auto under = direction(pixel)) return *under;
    const glm::dvec2 at = plane(pixel);
    if (!camera_.dome)
        return turned(camera_, disk_direction(at * (radius() * (1 - 1e-12) / glm::length(at))));
    glm::dvec3 h = glm::transpose(to_view_) * glm::dvec3(at, 0);
    if (!camera_.below) h.z = std::max(h.z, 0.0);
    const double length = glm::length(h);
    return length > 0 ? turned(camera_, h / length) : glm::dvec3(0, 0, 1);
}

glm::dvec2 HemisphereView::pixel(glm::dvec3 normal) const {
    const glm::dvec3 h = turned(camera_, normal);
    const glm::dvec2 at = (camera_.dome ? glm::dvec2(to_view_ * h) : disk_point(h)) - camera_.centre;
    return 0.5 * size_ + glm::dvec2(at.x, -at.y) * unit_;
}

glm::dvec2 HemisphereView::disk_pixel(glm::dvec2 at) const {
    const double r = glm::length(at), outermost = (camera_.below ? nadir : 1) * (1 - 1e-9);
    if (camera_.dome) return pixel(disk_direction(r > outermost ? at * (outermost / r) : at));
    const glm::dvec2 off = (camera_.highlight ? -at : at) - camera_.centre;
    return 0.5 * size_ + glm::dvec2(off.x, -off.y) * unit_;
}

glm::dvec2 HemisphereView::disk_under(glm::dvec2 pixel) const {
    if (camera_.dome) return disk_point(nearest_direction(pixel));
    return camera_.highlight ? -plane(pixel) : plane(pixel);
}

bool HemisphereView::hidden(glm::dvec3 h) const {
    if (h.z < 0 && !camera_.below) return true;
    if (!camera_.dome) return false;
    const glm::dvec3 seen = to_view_ * turned(camera_, h);
    if (seen.z >= 0) return false;
    // The hollow side shows where nothing of the dome stands before it.
    return camera_.below || (glm::transpose(to_view_) * glm::dvec3(seen.x, seen.y, -seen.z)).z >= 0;
}

double HemisphereView::coverage(glm::dvec2 pixel) const {
    if (camera_.dome) {
        double inside = 0;  // four samples: the dome's outline is no plain circle
        for (const glm::dvec2 off : {glm::dvec2(-0.3, -0.1), {0.1, -0.3}, {0.3, 0.1}, {-0.1, 0.3}})
            inside += direction(pixel + off) ? 0.25 : 0;
        return inside;
    }
    return std::clamp((radius() - glm::length(plane(pixel))) * unit_ + 0.5, 0.0, 1.0);
}

HemisphereCamera zoomed(const HemisphereView& view, glm::dvec2 pixel, double factor) {
    HemisphereCamera camera = view.camera();
    const double before = camera.zoom;
    camera.zoom = std::clamp(before * factor, zoom_min, zoom_max);
    const glm::dvec2 off = (pixel - 0.5 * view.size()) / view.pixels_per_unit();
    camera.centre += glm::dvec2(off.x, -off.y) * (1 - before / camera.zoom);
    keep_in_sight(camera);
    return camera;
}

HemisphereCamera panned(const HemisphereView& view, glm::dvec2 pixels) {
    HemisphereCamera camera = view.camera();
    camera.centre += glm::dvec2(-pixels.x, pixels.y) / view.pixels_per_unit();
    keep_in_sight(camera);
    return camera;
}

HemisphereCamera dragged(const HemisphereView& view, glm::dvec2 pixels) {
    HemisphereCamera camera = view.camera();
    if (!camera.dome) return panned(view, pixels);
    camera.yaw = std::remainder(camera.yaw + pixels.x * degrees_per_pixel, 360.0);
    camera.pitch = std::clamp(camera.pitch + pixels.y * degrees_per_pixel, 0.0, 90.0);
    return camera;
}

}  // namespace nacre
