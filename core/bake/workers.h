// The threads of one bake.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <stop_token>
#include <type_traits>
#include <utility>

namespace nacre {

struct BakeCancelled : std::runtime_error {
    BakeCancelled() : std::runtime_error("the bake was stopped") {}
};

class Workers {
  public:
    // threads = 0, or more than the machine has: all of the machine's.
    explicit Workers(int threads, std::stop_token stop = {});
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    void check() const {
        if (stop_.stop_requested()) throw BakeCancelled();
    }

    // Runs `work`, so that what it starts in parallel keeps to these threads.
    template <class Work>
    auto run(const Work& work) {
        std::optional<std::invoke_result_t<const Work&>> result;
        execute([&] { result.emplace(work()); });
        return *std::move(result);
    }

    // Calls visit(i) for every i below `count`; results must not depend on order. Throws BakeCancelled.
    void for_each(int count, const std::function<void(int)>& visit);

  private:
    void execute(const std::function<void()>& work);

    struct Arena;  // oneTBB's, whose headers everything that can bake would read
    std::stop_token stop_;
    std::unique_ptr<Arena> arena_;
};

}  // namespace nacre
