// A picture that comes in, by a drop or by File > Import: it is read on a worker, cards show what it could
// be, and the chosen one is done.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/designer/file_chooser.h"
#include "app/designer/import_job.h"
#include "app/preview/gl_objects.h"
#include "core/paint/stamps.h"
#include "ui/import_dialog.h"

namespace nacre {

class ImageImport {
  public:
    // `wake` is called on the worker's thread when there is something to show. Needs a current OpenGL 3.3
    // context from its beginning to its end.
    explicit ImageImport(std::function<void()> wake = {});

    // Asks for a file, from this folder unless a picture has been chosen before.
    void ask(const std::filesystem::path& folder, const std::optional<DialogProgram>& dialogs);

    // A file that is to be imported; the newest counts.
    void offer(const std::filesystem::path& file);

    // Asks the worker for what is missing, and takes what it has made; once a frame. A modulation is for the
    // chosen layer, and the cards are drawn as the canvas is.
    void follow(Distribution& distribution, std::size_t& chosen, ScaleKind scale);

    // What is open, and acts on the answer: the picture becomes a painted layer of its light, its normals or
    // its heights, the chosen layer's modulation, or the environment map.
    void draw(const Distribution& distribution);

    // The picture that was stamped, once: it is a stamp for the hand too.
    struct Stamp {
        NamedStamp stamp;
        StampPose pose;
    };
    std::optional<Stamp> take_stamp() { return std::exchange(stamp_, std::nullopt); }

    // The picture that was chosen as environment map, once.
    std::optional<std::filesystem::path> take_environment() {
        return std::exchange(environment_, std::nullopt);
    }

    // The panel that has the settings of what came of a picture, once; else null.
    const char* take_panel() { return std::exchange(panel_, nullptr); }

    // What is to be said of the picture that was used, once.
    std::optional<std::string> take_note() { return std::exchange(note_, std::nullopt); }

    bool talking() const { return file_ || chooser_.open() || !problem_.empty(); }
    const std::string& problem() const { return problem_; }  // shown until it is read
    bool choosing() const {
        return file_ && !making_ && problem_.empty();
    }                                                     // another file may take its place
    bool reading() const { return file_ && !settings_; }  // nothing is known of the picture yet
    bool in_motion() const { return chooser_.has_answer(); }
    void wait() const { job_.wait(); }

  private:
    ImportUse use() const { return static_cast<ImportUse>(card_); }
    void submit(const Layer& modulated, ScaleKind scale);
    void take(ImportSight sight);
    void apply(const ImportSight& sight, Distribution& distribution, std::size_t& chosen);
    void add_layer(const MadeRaster& made, const PictureSource& source, Distribution& distribution,
                   std::size_t& chosen);
    void draw_cards(const Distribution& distribution);
    std::array<ui::ImportCard, import_uses> cards(const Distribution& distribution) const;
    void settings_fields();
    void accept();
    void give_up();

    FileChooser chooser_;
    std::optional<std::filesystem::path> file_;  // that is being imported
    std::filesystem::path last_folder_;
    std::optional<PictureSource> settings_;  // once it has been read
    std::size_t card_ = 0;                   // chosen
    bool asks_ = false;                      // for what these settings make
    bool making_ = false;                    // the picture is being used
    ImportSight sight_;
    std::array<std::unique_ptr<Texture>, import_uses> textures_;
    std::string problem_;
    std::optional<Stamp> stamp_;
    std::optional<std::filesystem::path> environment_;
    std::optional<std::string> note_;
    const char* panel_ = nullptr;
    PictureSource usual_;                                    // as it was last set
    std::map<std::filesystem::path, PictureSource> chosen_;  // for the session
    std::uint64_t asked_ = 0, first_ = 0;  // the newest request, and the first whose answer counts
    LatestJob<ImportRequest, ImportSight> job_;
};

}  // namespace nacre
