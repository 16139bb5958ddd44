// nacre [DESIGN] [--ui-scale X]
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "app/designer/designer.h"
#include "app/designer/imgui_session.h"
#include "app/desktop/key_latch.h"
#include "app/desktop/pace.h"
#include "app/desktop/window.h"
#include "core/design/design_file.h"

namespace {

struct Arguments {
    std::string design;
    float ui_scale = 0;  // 0: the monitor's
};

void run(const Arguments& arguments) {
    nacre::Document document;
    if (!arguments.design.empty())
        document = nacre::Document(nacre::load_design(arguments.design),
                                   std::filesystem::absolute(arguments.design));
    nacre::Window window({1280, 800}, "Nacre");
    const nacre::ImguiSession session(arguments.ui_scale > 0 ? arguments.ui_scale : window.monitor_scale());
    nacre::KeyLatch keys(window.handle());
    ImGui_ImplGlfw_InitForOpenGL(window.handle(), true);
    {
        nacre::Designer designer;
        designer.document = std::move(document);
        nacre::Pace pace;
        while (!designer.files.may_quit()) {
            const bool due = pace.wait(nacre::in_motion(designer));
            if (window.take_close_request()) nacre::perform(designer, nacre::ui::Command::quit);
            if (!due) continue;
            session.new_frame();
            ImGui_ImplGlfw_NewFrame();
            keys.press_missed();
            for (const std::string& file : keys.take_dropped()) take_file(designer, file);
            ImGui::NewFrame();
            nacre::draw_frame(designer);
            keys.release_missed();
            ImGui::Render();
            session.draw(window.framebuffer_size());
            window.swap();
            window.set_title(designer.document.title() + " \u2013 Nacre");
        }
    }
    ImGui_ImplGlfw_Shutdown();
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App options("Nacre: design the highlight of a surface", "nacre");
    Arguments arguments;
    options.add_option("DESIGN", arguments.design, "a .nacre file to open");
    options.add_option("--ui-scale", arguments.ui_scale, "size of text and widgets; 1 is normal")
        ->check(CLI::Range(0.5, 4.0));
    try {
        options.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return options.exit(error) == 0 ? 0 : 2;
    }
    try {
        run(arguments);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "nacre: %s\n", error.what());
        return 1;
    }
    return 0;
}
