#include "tests/crash/child/shortage.h"

#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>

#include "app/headless/stage.h"
#include "core/base/error.h"
#include "core/formats/export_format.h"

namespace nacre::test {
namespace {

namespace fs = std::filesystem;

class Hand {
  public:
    Hand() { play("frames 2\nwait"); }

    Designer& designer() { return stage_.designer(); }
    void play(const std::string& events) { stage_.play(parse_events(events, "shortage")); }

    // Waits for the question on the screen, and tells what it says.
    template <class Problem>
    void told(const char* what, const Problem& problem) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
        while (problem().empty()) {
            if (std::chrono::steady_clock::now() > end)
                throw std::runtime_error(std::string(what) + ": not told");
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            play("frames 1");
        }
        // Below the words the path of a picture may stand.
        std::printf("%s: %s\n", what, problem().substr(0, problem().find('\n')).c_str());
    }
    void answer() {
        play("frames 30\nkey Enter\nframes 5");
        if (talking(designer())) throw std::runtime_error("the answer is not taken");
    }

  private:
    HeadlessDesigner stage_{{.bake_threads = 1}};
};

// The process can take so many bytes more and no others, for as long as this lives.
class MemoryLimit {
  public:
    explicit MemoryLimit(rlim_t more) {
        mallopt(M_MMAP_THRESHOLD, 1 << 18);  // what is large comes from the system, and goes back to it
        malloc_trim(0);
        getrlimit(RLIMIT_AS, &old_);
        rlim_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        const rlimit limit{pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + more, old_.rlim_max};
        setrlimit(RLIMIT_AS, &limit);
    }
    ~MemoryLimit() { setrlimit(RLIMIT_AS, &old_); }
    MemoryLimit(const MemoryLimit&) = delete;
    MemoryLimit& operator=(const MemoryLimit&) = delete;

  private:
    rlimit old_{};
};

constexpr rlim_t slack = rlim_t{3} << 20;  // for what is small

// Up to the Enter that begins the work.
void export_to(Hand& hand, std::size_t format, const fs::path& file) {
    hand.play("key Ctrl+E\nframes 3");
    hand.designer().exporter.options().chosen = format;
    hand.play("click \"Choose export file\"\nframes 3\nkey Ctrl+A\ntext \"" + file.string() + "\"\nframes 2");
}

}  // namespace

void without_pictures(const fs::path& folder) {
    Hand hand;
    Designer& designer = hand.designer();
    const fs::path picture = folder / "picture.png";
    take_file(designer, picture);
    hand.told("picture", [&] { return designer.pictures.problem(); });
    hand.answer();
    designer.stamps.want(picture);
    hand.told("Stamp", [&] { return designer.stamps.problem(); });
    hand.answer();
    designer.environment.want(picture.string());
    hand.told("environment", [&] { return designer.environment.problem(); });
    hand.answer();
    take_file(designer, folder / "pictured.nacre");
    hand.told("design", [&] { return designer.files.problem(); });
    hand.answer();
    export_to(hand, export_formats().size(), folder / "out.png");
    hand.play("key Enter\nframes 3");
    hand.told("export", [&] { return designer.exporter.problem(); });
    hand.answer();
    designer.settings.values.picture_folder = folder;
    hand.play("key F12");
    hand.told("F12", [&] { return designer.pictures_of_preview.problem(); });
    hand.answer();
}

void without_memory(const fs::path& folder) {
    Hand hand;
    Designer& designer = hand.designer();
    {
        const MemoryLimit limit(slack);
        take_file(designer, folder / "large.nacre");
        hand.told("open", [&] { return designer.files.problem(); });
        if (!designer.document.file.empty()) throw std::runtime_error("it was opened all the same");
    }
    hand.answer();
    take_file(designer, folder / "large.nacre");
    hand.play("frames 3");
    designer.layers.chosen = 1;
    hand.play("click \"Paint\"\nwait");
    const Design before = designer.document.design;
    {
        const MemoryLimit limit(slack);
        hand.play("drag \"Canvas\":@5,10 \"Canvas\":@40,60 8");
        hand.told("stroke", [&] { return designer.files.problem(); });
        if (designer.document.design != before) throw std::runtime_error("half a stroke stayed");
    }
    hand.answer();
    hand.play("wait");
    export_to(hand, 1, folder / "out.glsl");
    {
        const MemoryLimit limit(slack);
        hand.play("key Enter\nframes 3");
        hand.told("export", [&] { return designer.exporter.problem(); });
    }
    hand.answer();
    hand.play("drag \"Canvas\":@5,10 \"Canvas\":@40,60 8\nframes 3");
    if (designer.document.design == before)
        throw std::runtime_error("nothing can be painted any more: " + designer.files.problem());
}

}  // namespace nacre::test
