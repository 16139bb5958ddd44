// A picture that comes in, and the question what to do with it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "app/designer/normal_choice.h"
#include "core/design/design.h"

namespace nacre {

// How a map of normals or heights becomes facets.
struct ReliefReading {
    double smoothing = 1.5;  // degrees, standard deviation of the normals
    double height = 2;  // from black to white, in percent of the picture's width; negative: black is high
};

class ImageImport {
  public:
    // A file was dropped on the window; the newest counts.
    void offer(std::filesystem::path file) {
        file_ = std::move(file);
        normals_.look_at(*file_);
    }

    // Asks, and acts on the answer: the picture becomes the stamp in hand, a painted layer of its normals or
    // of its heights, the chosen layer's modulation, or the environment map.
    void draw(Distribution& distribution, std::size_t& chosen);

    // The picture that was said to be a stamp, once.
    std::optional<std::filesystem::path> take_stamp() { return std::exchange(stamp_, std::nullopt); }

    // The picture that was chosen as environment map, once.
    std::optional<std::filesystem::path> take_environment() {
        return std::exchange(environment_, std::nullopt);
    }

    // What is to be said of the picture that was used, once.
    std::optional<std::string> take_note() { return std::exchange(note_, std::nullopt); }

    bool talking() const { return file_ || !problem_.empty(); }
    const std::string& problem() const { return problem_; }  // shown until it is read

  private:
    void use(int answer, Distribution& distribution, std::size_t& chosen);

    std::optional<std::filesystem::path> file_, stamp_, environment_;
    std::string problem_;
    std::optional<std::string> note_;
    ReliefReading reading_;  // as it was last set
    NormalChoice normals_;
};

}  // namespace nacre
