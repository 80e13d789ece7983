// A scene file that lives as long as the test looks at it.
#pragma once
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace ritz::test {

class TemporaryScene {
 public:
  explicit TemporaryScene(const std::string& text) {
    static int count = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("ritz_scene_" + std::to_string(getpid()) + "_" + std::to_string(count++) + ".toml");
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~TemporaryScene() { std::filesystem::remove(path_); }
  TemporaryScene(const TemporaryScene&) = delete;
  TemporaryScene& operator=(const TemporaryScene&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace ritz::test
