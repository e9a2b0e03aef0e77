// Reads every #include of the four modules: arrows point one way, and each outside library has one
// door.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

struct Include {
    std::string file; // from the root
    int line = 0;
    std::string target;
};

std::string first_folder(const std::string& path) {
    return path.substr(0, path.find('/'));
}

std::vector<Include> includes_below(const std::string& module) {
    static const std::regex directive(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
    const fs::path root = PAIRLIGHT_SOURCE_DIR;
    std::vector<Include> found;
    for (const auto& entry : fs::recursive_directory_iterator(root / module)) {
        const auto extension = entry.path().extension();
        if (extension != ".h" && extension != ".cpp")
            continue;
        std::ifstream stream(entry.path());
        std::string text;
        for (int line = 1; std::getline(stream, text); ++line)
            if (std::smatch match; std::regex_search(text, match, directive))
                found.push_back({fs::relative(entry.path(), root).string(), line, match[1]});
    }
    return found;
}

const std::set<std::string> modules{"renderer", "protocols", "analysis", "experiment"};

TEST(Layering, ArrowsPointOneWay) {
    const std::map<std::string, std::set<std::string>> may_include{
        {"renderer", {"renderer"}},
        {"protocols", {"protocols"}},
        {"analysis", {"analysis", "protocols"}},
        {"experiment", {"experiment", "renderer", "protocols", "analysis"}}};
    for (const auto& [module, allowed] : may_include) {
        const auto includes = includes_below(module);
        ASSERT_FALSE(includes.empty()) << module << ": no file was read";
        for (const auto& include : includes) {
            const auto target = first_folder(include.target);
            EXPECT_TRUE(!modules.contains(target) || allowed.contains(target))
                << include.file << ':' << include.line << " includes " << include.target;
        }
    }
}

/// The room a file of a module stands in: its folder, or nothing at the module's root.
std::string room_of(const std::string& path) {
    const auto module = path.find('/');
    const auto end = path.find('/', module + 1);
    return end == std::string::npos ? std::string() : path.substr(module + 1, end - module - 1);
}

// Rooms stand on each other, so each can be read knowing only those below it: taking away, again
// and again, every room that includes none of those that are left takes away all of them.
TEST(Layering, RoomsOfTheRendererFormNoCircle) {
    std::map<std::string, std::set<std::string>> below;
    for (const auto& include : includes_below("renderer")) {
        const auto from = room_of(include.file), to = room_of(include.target);
        if (first_folder(include.target) == "renderer" && !from.empty() && !to.empty()) {
            below[to];
            if (from != to)
                below[from].insert(to);
        }
    }
    ASSERT_GE(below.size(), 10U) << "too few rooms were read";
    const auto stands_on_ground = [](const auto& room) { return room.second.empty(); };
    for (auto ground = std::find_if(below.begin(), below.end(), stands_on_ground);
         ground != below.end();
         ground = std::find_if(below.begin(), below.end(), stands_on_ground)) {
        const auto name = ground->first;
        below.erase(ground);
        for (auto& [room, others] : below)
            others.erase(name);
    }
    for (const auto& [room, others] : below)
        for (const auto& other : others)
            ADD_FAILURE() << "on a circle, or above one: " << room << " includes " << other;
}

// A name says where to look: what renderer/shading/ declares is in renderer::shading.
TEST(Layering, NamespacesFollowFolders) {
    static const std::regex opened(R"(^namespace ([a-z_:]+) \{)");
    const fs::path root = PAIRLIGHT_SOURCE_DIR;
    for (const auto& module : modules)
        for (const auto& entry : fs::recursive_directory_iterator(root / module)) {
            if (entry.path().extension() != ".h")
                continue;
            const auto file = fs::relative(entry.path(), root);
            const auto expected =
                std::regex_replace(file.parent_path().string(), std::regex("/"), "::");
            std::ifstream stream(entry.path());
            std::string text;
            std::set<std::string> found;
            while (std::getline(stream, text))
                if (std::smatch match; std::regex_search(text, match, opened))
                    found.insert(match[1]);
            EXPECT_TRUE(found.empty() || found.contains(expected)) // empty: macros alone
                << file << " declares nothing in " << expected;
        }
}

// The libraries whose types stop at a folder's door, and the folder (or file) that is the door; one
// that two rooms use apart from each other has two.
TEST(Layering, EachOutsideLibraryHasOneDoor) {
    const std::vector<std::pair<std::string, std::string>> doors{
        {"embree3/", "renderer/geometry/"},
        {"OpenImageIO/", "renderer/imaging/"},
        {"epoxy/", "renderer/gpu/"},
        {"tiny_obj_loader.h", "renderer/geometry/"},
        {"OpenMesh/", "renderer/geometry/"},
        {"tbb/", "renderer/"},
        {"openssl/", "protocols/"},
        {"toml++/", "protocols/"},
        {"boost/multiprecision", "protocols/"},
        {"Eigen/", "analysis/"},
        {"Eigen/", "renderer/smoothing/"},
        {"Eigen/", "renderer/transfer/"},
        {"boost/math", "analysis/numerics/"},
        {"boost/math", "renderer/reference/"},
        {"sqlite3.h", "experiment/store/"},
        {"GLFW/", "experiment/session/"},
        {"CLI/", "experiment/commands/command_line.cpp"},
        {"CLI/", "experiment/commands/option.cpp"},
        {"CLI/", "experiment/commands/wrong_words.cpp"},
    };
    const auto stands_in_a_door = [&](const std::string& file, const std::string& library) {
        return std::any_of(doors.begin(), doors.end(), [&](const auto& each) {
            return each.first == library && file.starts_with(each.second);
        });
    };
    for (const auto& module : modules)
        for (const auto& include : includes_below(module))
            for (const auto& [library, door] : doors)
                EXPECT_TRUE(!include.target.starts_with(library) ||
                            stands_in_a_door(include.file, library))
                    << include.file << ':' << include.line << ": " << library << " belongs behind "
                    << door;
}

// Headers stay light: what is slow to compile is included by .cpp files only.  A library's names
// without its bodies are light.
TEST(Layering, HeadersAreLight) {
    const std::vector<std::string> heavy{"OpenImageIO/", "Eigen/",    "boost/",
                                         "nlohmann/",    "toml++/",   "CLI/",
                                         "tbb/",         "sqlite3.h", "OpenMesh/"};
    for (const auto& module : modules)
        for (const auto& include : includes_below(module))
            for (const auto& library : heavy)
                EXPECT_FALSE(include.file.ends_with(".h") && include.target.starts_with(library) &&
                             include.target != "nlohmann/json_fwd.hpp")
                    << include.file << ':' << include.line << " includes " << include.target;
}

} // namespace
