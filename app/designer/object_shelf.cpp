#include "app/designer/object_shelf.h"

#include <algorithm>
#include <exception>

namespace nacre {
namespace {

bool is_file(const std::string& name) {
    const auto names = object_names();
    return std::find(names.begin(), names.end(), name) == names.end();
}

std::string what(const std::exception_ptr& error) {
    try {
        std::rethrow_exception(error);
    } catch (const std::exception& refused) {
        return refused.what();
    }
}

}  // namespace

ObjectShelf::ObjectShelf()
    : job_([this](const std::string& name, const std::stop_token&, const auto& publish) {
          if (is_file(name)) return publish(make_object(name));
          auto found = made_.find(name);
          if (found == made_.end()) found = made_.emplace(name, make_object(name)).first;
          publish(found->second);
      }) {}

void ObjectShelf::want(const std::string& name) {
    wanted_ = name;
    waiting_ = true;
    job_.submit(name);
}

std::optional<SceneObject> ObjectShelf::poll() {
    const auto published = job_.poll();
    if (!published) return {};
    waiting_ = job_.busy();
    if (published->error) {
        problem_ = what(published->error);
        return {};
    }
    return published->result;
}

}  // namespace nacre
