#include "app/designer/image_import.h"

#include <system_error>
#include <utility>

#include "app/designer/picture_notes.h"
#include "app/designer/picture_trouble.h"
#include "app/designer/private_json_file.h"
#include "core/paint/layer_paint.h"
#include "core/paint/painted_layer.h"
#include "ui/dialogs.h"
#include "ui/source_fields.h"
#include "ui/widgets.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

struct UseText {
    const char* name;
    const char* about;
    const char* panel;  // where its settings are afterwards
};

// In the order of the uses.
constexpr std::array<UseText, import_uses> texts{
    {{"Stamp",
      "A highlight of the picture's shape, as a new layer. It is a stamp for the brush too. White paints; "
      "on a white or transparent ground the dark does.",
      "Layers"},
     {"Normals", "A layer with the facets of the surface whose normals the picture holds as colours.",
      "Layers"},
     {"Heights", "A layer with the facets of the surface whose heights the picture holds as brightness.",
      "Layers"},
     {"Modulation",
      "The chosen layer multiplied by the picture, as by a mask over its highlight. A picture that is not "
      "square keeps its shape, with black beside it.",
      "Layers"},
     {"Environment map", "The world around the object: a lat-long picture that lights it.", "Light"}}};

bool adds_layer(ImportUse use) { return use != ImportUse::modulation && use != ImportUse::environment; }

std::string joined(const PictureNotes& notes) {
    std::string text;
    for (const std::string& note : notes) text += (text.empty() ? "" : " ") + sentence(note);
    return text;
}

}  // namespace

ImageImport::ImageImport(std::function<void()> wake)
    : job_([worker = std::make_shared<ImportWorker>()](
               const ImportRequest& request, const std::stop_token& stop,
               const auto& publish) { worker->work(request, stop, publish); },
           std::move(wake)) {}

void ImageImport::ask(const fs::path& folder, const std::optional<DialogProgram>& dialogs) {
    std::vector<std::string> extensions = picture_extensions();
    extensions.emplace_back(".svg");
    chooser_.ask({.purpose = ui::FileDialog::Purpose::open,
                  .title = "Import picture",
                  .folder = last_folder_.empty() ? folder : last_folder_,
                  .kind = "Picture",
                  .extensions = std::move(extensions)},
                 dialogs);
}

void ImageImport::offer(const fs::path& file) {
    give_up();
    textures_ = {};
    std::error_code error;
    const fs::path absolute = fs::absolute(file, error).lexically_normal();
    file_ = error ? file : absolute;
    last_folder_ = file_->parent_path();
    asks_ = true;
}

void ImageImport::give_up() {
    file_.reset();
    settings_.reset();
    sight_ = {};
    asks_ = making_ = false;
    if (asked_ > 0) asked_ = job_.submit({});  // the worker keeps no picture
    first_ = asked_ + 1;
}

void ImageImport::submit(const Layer& modulated, ScaleKind scale) {
    ImportRequest request{
        .settings = usual_, .modulated = modulated, .scale = scale, .use = use(), .make = making_};
    request.settings.image = *file_;
    const auto before = chosen_.find(*file_);
    if (settings_)
        request.settings = *settings_;
    else if (before != chosen_.end())
        request.settings = before->second;
    else
        request.settings.rotation = 0, request.settings.flip = false;
    request.by_look = !settings_ && before == chosen_.end();
    asked_ = job_.submit(std::move(request));
    asks_ = false;
}

void ImageImport::take(ImportSight sight) {
    if (!settings_) {
        settings_ = sight.settings;
        card_ = static_cast<std::size_t>(sight.guess.use);
    }
    for (std::size_t i = 0; i < import_uses; ++i) {
        if (!sight.previews[i] || sight.previews[i] == sight_.previews[i]) continue;
        const HemispherePicture& picture = sight.previews[i]->picture;
        if (picture.rgba.empty()) continue;
        if (!textures_[i]) textures_[i] = std::make_unique<Texture>();
        textures_[i]->store(picture.size, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data(),
                            GL_LINEAR);
    }
    sight_ = std::move(sight);
}

void ImageImport::follow(Distribution& distribution, std::size_t& chosen, ScaleKind scale) {
    if (auto published = job_.poll(); published && file_ && published->revision >= first_) {
        if (published->error) {
            problem_ = picture_trouble(*file_, published->error);
            give_up();
        } else if (!published->result->made) {
            take(*std::move(published->result));
        } else if (making_) {
            apply(*published->result, distribution, chosen);
            give_up();
        }
    }
    const bool has_layer = chosen < distribution.layers.size();
    if (file_ && asks_) submit(has_layer ? distribution.layers[chosen] : Layer{}, scale);
}

void ImageImport::add_layer(const MadeRaster& made, const PictureSource& source, Distribution& distribution,
                            std::size_t& chosen) {
    const std::size_t before = distribution.layers.size();
    add_painted_layer(distribution, chosen);
    if (distribution.layers.size() == before) return;
    Layer& layer = distribution.layers[chosen];
    layer.name = file_->stem().string();
    const double others = weight_of_others(distribution, chosen);
    set_raster(layer, made.raster, 0, others > 0 ? others : 1);
    if (json_path(*file_)) layer.source = source;
}

void ImageImport::apply(const ImportSight& sight, Distribution& distribution, std::size_t& chosen) {
    const MadeRaster& made = *sight.made;
    if (use() != ImportUse::modulation)
        add_layer(made, sight.settings, distribution, chosen);
    else if (chosen < distribution.layers.size())
        distribution.layers[chosen].modulation = Modulation{{{}, made.raster, made.notes}, 1};
    if (sight.stamp)
        stamp_ = Stamp{named_stamp(file_->stem().string(), sight.stamp),
                       {.angle = sight.settings.rotation, .flip = sight.settings.flip}};
    panel_ = texts[card_].panel;
    if (!made.notes.empty()) note_ = notes_line(*file_, made.notes);
}

void ImageImport::accept() {
    chosen_[*file_] = usual_ = *settings_;
    if (use() == ImportUse::environment) {
        environment_ = *file_;
        panel_ = texts[card_].panel;
        give_up();
        return;
    }
    making_ = asks_ = true;
    first_ = asked_ + 1;
}

std::array<ui::ImportCard, import_uses> ImageImport::cards(const Distribution& distribution) const {
    std::array<ui::ImportCard, import_uses> cards{};
    for (std::size_t i = 0; i < import_uses; ++i) {
        ui::ImportCard& card = cards[i];
        card = {.name = texts[i].name, .about = texts[i].about};
        if (textures_[i])
            card.picture = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(textures_[i]->name()));
        if (sight_.previews[i]) card.refusal = sight_.previews[i]->refusal;
        if (adds_layer(static_cast<ImportUse>(i)) && distribution.layers.size() >= limits::layers_max)
            card.refusal = "The design has " + std::to_string(limits::layers_max) +
                           " layers, which is as many as there can be.";
    }
    return cards;
}

void ImageImport::settings_fields() {
    PictureSource& settings = *settings_;
    const PictureSource before = settings;
    switch (use()) {
        case ImportUse::environment:
            ui::dim_text("Rotation and brightness are in the panel Light.");
            return;
        case ImportUse::modulation:
            ui::pose_fields(settings);
            break;
        case ImportUse::stamp:
            settings.as = SourceUse::stamp;
            ui::source_fields(settings);
            break;
        case ImportUse::normals:
            settings.as = SourceUse::normals;
            ui::source_fields(settings, {.look = &sight_.look});
            break;
        case ImportUse::heights:
            settings.as = SourceUse::heights;
            ui::source_fields(settings);
            break;
    }
    settings.as = before.as;
    if (settings == before) return;
    chosen_[*file_] = usual_ = settings;
    asks_ = true;
}

void ImageImport::draw_cards(const Distribution& distribution) {
    const auto shown = cards(distribution);
    const auto& preview = sight_.previews[card_];
    const ui::ImportContents contents{.name = file_->filename().string(),
                                      .cards = shown,
                                      .likely = static_cast<std::size_t>(sight_.guess.use),
                                      .why = sight_.guess.why,
                                      .remark = preview ? joined(preview->notes) : ""};
    const ui::ImportAnswer answer = ui::import_dialog(contents, card_, [this] { settings_fields(); });
    if (answer == ui::ImportAnswer::accepted) accept();
    if (answer == ui::ImportAnswer::cancelled) give_up();
}

void ImageImport::draw(const Distribution& distribution) {
    if (!problem_.empty()) {
        if (ui::question("Cannot import the picture", problem_, {"OK"})) problem_.clear();
    } else if (chooser_.open()) {
        const auto answer = chooser_.draw();
        if (answer && !answer->chosen.empty()) offer(answer->chosen);
    } else if (file_ && settings_ && !making_) {
        draw_cards(distribution);
    } else if (file_) {
        const std::string name = "\u201c" + file_->filename().string() + "\u201d \u2026";
        if (making_ ? ui::waiting_dialog("Importing", "Making the layer from " + name)
                    : ui::waiting_dialog("Import picture", "Reading " + name))
            give_up();
    }
}

}  // namespace nacre
