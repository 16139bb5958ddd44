#include "app/designer/object_shelf.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "core/base/error.h"

namespace nacre {
namespace {

bool is_file(const std::string& name) {
    const auto names = object_names();
    return std::find(names.begin(), names.end(), name) == names.end();
}

}  // namespace

ObjectShelf::ObjectShelf()
    : job_([this](const std::string& name, const std::stop_token&, const auto& publish) {
          if (is_file(name)) {
              HeldFiles held = held_now(std::array<std::filesystem::path, 1>{name});
              return publish({make_object(name), std::move(held)});
          }
          auto found = made_.find(name);
          if (found == made_.end()) found = made_.emplace(name, make_object(name)).first;
          publish({found->second, {}});
      }) {}

void ObjectShelf::want(const std::string& name) {
    wanted_ = name;
    waiting_ = true;
    job_.submit(name);
}

std::optional<SceneObject> ObjectShelf::poll() {
    auto published = job_.poll();
    if (!published) return {};
    waiting_ = job_.busy();
    if (published->error) {
        problem_ = problem_line(published->error);
        return {};
    }
    held_ = std::move(published->result->held);
    return std::move(published->result->object);
}

}  // namespace nacre
