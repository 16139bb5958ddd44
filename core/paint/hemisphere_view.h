// Where the facet normals lie on a flat picture: the equal-area disk from above, or a dome that is orbited.
// Facets that are tilted to one side shine on the other side of a highlight's middle, so that a sphere under
// one light shows p turned by 180 degrees about n. The highlight's view turns the picture the same way: what
// is painted above stands above on the object.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

namespace nacre {

// What an artist turns: no part of the document.
struct HemisphereCamera {
    bool highlight = true;    // as it stands on the lit sphere; else by the normals' own x and y
    bool dome = false;        // seen from the side instead of as the disk
    bool below = false;       // facets below the horizon are shown too
    glm::dvec2 centre{0, 0};  // the disk's point (or the dome's, in radii) in the middle of the picture
    double zoom = 1;          // 1 shows all
    double yaw = -25;         // degrees, of the dome about n
    double pitch = 50;        // degrees, by which n is tilted toward the viewer; 90 looks down on n

    // The same kind of picture with all of it shown.
    HemisphereCamera whole() const { return {.highlight = highlight, .dome = dome, .below = below}; }

    bool operator==(const HemisphereCamera&) const = default;
};

inline constexpr double zoom_min = 1, zoom_max = 40;

// From the surface's frame to a viewer's: x right, y up, z toward the viewer. Degrees, as a camera has them.
glm::dmat3 to_view(double yaw, double pitch);

// Pixels count from the picture's left top corner.
class HemisphereView {
  public:
    HemisphereView(const HemisphereCamera& camera, glm::dvec2 size);

    // The unit normal under a pixel; nothing beside the disk or the dome.
    std::optional<glm::dvec3> direction(glm::dvec2 pixel) const;

    // The normal under a pixel, or under the nearest point of the rim for a pixel beside it.
    glm::dvec3 nearest_direction(glm::dvec2 pixel) const;

    // Where a normal is seen, whether or not it is hidden behind the dome.
    glm::dvec2 pixel(glm::dvec3 h) const;
    bool hidden(glm::dvec3 h) const;

    // The same of points on the surface's equal-area disk, which a picture of the disk shows beside it too.
    glm::dvec2 disk_pixel(glm::dvec2 at) const;
    glm::dvec2 disk_under(glm::dvec2 pixel) const;

    // How much of a pixel the disk or the dome covers, as an edge one pixel wide: 0 beside it, 1 on it.
    double coverage(glm::dvec2 pixel) const;

    double pixels_per_unit() const { return unit_; }  // radii of the horizon
    glm::dvec2 size() const { return size_; }
    const HemisphereCamera& camera() const { return camera_; }

  private:
    glm::dvec2 plane(glm::dvec2 pixel) const;
    std::optional<glm::dvec3> shown(glm::dvec2 pixel) const;  // before the highlight's view is turned back
    double radius() const;                                    // of what is shown, in radii of the horizon

    HemisphereCamera camera_;
    glm::dvec2 size_;
    double unit_;
    glm::dmat3 to_view_;  // of the dome: x right, y up, z toward the viewer
};

// The camera after a turn of the wheel that keeps what lies under `pixel` there. At zoom 1 all is shown.
HemisphereCamera zoomed(const HemisphereView& view, glm::dvec2 pixel, double factor);

// The camera after a drag, in pixels, that moves the picture.
HemisphereCamera panned(const HemisphereView& view, glm::dvec2 pixels);

// The same, but for a dome, which is turned.
HemisphereCamera dragged(const HemisphereView& view, glm::dvec2 pixels);

}  // namespace nacre
