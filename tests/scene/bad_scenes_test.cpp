// What is wrong in a scene costs one sentence with the file, the line and the remedy.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include "ritz/base/error.hpp"
#include "ritz/scene_file/read.hpp"
#include "scene/temporary_scene.hpp"

namespace ritz::scene {
namespace {

struct Bad {
  std::string text;
  std::string complaint;  ///< what follows the file's name: ":LINE: ..." or a part of it
};

const std::string time = "[time]\nstep = 0.1\nend = 1\n";  // three lines

const std::vector<Bad> bad_scenes = {
    {"", "needs [time] (step, end) or [static] (steps)"},
    {"[time\nstep = 1", ":1: not valid TOML"},
    {"[time]\nstep = 1\nstep = 2\nend = 3", ":3: not valid TOML"},
    {"[time]\nstep = = 1", ":2: not valid TOML"},
    {"\xff\xfe", "not valid TOML"},
    {"[time]\nstep = 1\nend = n\n", ":3: not valid TOML"},
    {"gr\\u001b[31mavity = 1\n" + time, "not valid TOML"},
    {"\"gr\\u001b[31m\" = 1\n" + time, ":1: unknown key 'gr\\x1b[31m' in the scene"},
    {"gravty = [0, 0, -9.81]\n" + time, ":1: unknown key 'gravty' in the scene; did you mean 'gravity'?"},
    {"[time]\nstpe = 0.1\nend = 1", ":2: unknown key 'stpe' in [time]; did you mean 'step'?"},
    {"[time]\nend = 1", "[time] needs the key 'step'"},
    {"[time]\nstep = 1", "[time] needs the key 'end'"},
    {"[time]\nstep = '0.1'\nend = 1", ":2: 'step' of [time] must be a number"},
    {"[time]\nstep = 0\nend = 1", ":2: 'step' of [time] must be greater than 0"},
    {"[time]\nstep = -0.1\nend = 1", ":2: 'step' of [time] must be greater than 0"},
    {"[time]\nstep = nan\nend = 1", ":2: 'step' of [time] must be a finite number"},
    {"[time]\nstep = 0.1\nend = inf", ":3: 'end' of [time] must be a finite number"},
    {"[time]\nstep = 1\nend = 0.5", ":3: 'end' of [time] must not be less than 'step'"},
    {"[time]\nstep = 1e-300\nend = 1", ":2: 'step' of [time] makes more than 1e12 steps"},
    {time + "integrator = 'newmarc'", ":4: unknown integrator 'newmarc'; did you mean 'newmark'?"},
    {time + "integrator = 3", ":4: 'integrator' of [time] must be a string"},
    {"time = 3", ":1: [time] must be a table of keys"},
    {time + "[static]\nsteps = 3", "the scene has both 'time' and 'static': keep one of them"},
    {"[static]", "[static] needs the key 'steps'"},
    {"[static]\nsteps = 0", ":2: 'steps' of [static] must be from 1 to 1000000"},
    {"[static]\nsteps = 2.5", ":2: 'steps' of [static] must be a whole number"},
    {"[static]\nsteps = 2\n[shake]\ndirection = [1, 0, 0]\ntable = [[0, 1]]", ":3: [shake] needs [time]"},
    {time + "[damping]\nalpha = -1", ":5: 'alpha' of [damping] must not be negative"},
    {time + "[damping]\nratio = [0.1, -0.1]", ":5: 'ratio' of [damping] must not be negative"},
    {time + "[damping]\nratio = ['a']", ":5: 'ratio' of [damping] must be a number"},
    {time + "[damping]\ngamma = 1", ":5: unknown key 'gamma' in [damping]; there are 'alpha', 'beta' and 'ratio'"},
    {"gravity = 9.81\n" + time, ":1: 'gravity' of the scene must be an array of numbers"},
    {"gravity = [0, -9.81]\n" + time, ":1: 'gravity' of the scene must have three components"},
    {"gravity = [0, 0, nan]\n" + time, ":1: 'gravity' of the scene must be a finite number"},
    {"[static]\nsteps = 1\n[initial]\nz = [1]", ":3: [initial] needs [time]"},
    {time + "[initial]", ":4: [initial] needs one of 'static', 'z', 'velocity' and 'motion'"},
    {time + "[initial]\nstatic = false", ":5: 'static' of [initial] must be true"},
    {time + "[initial]\nstatic = 1", ":5: 'static' of [initial] must be true"},
    {time + "[initial]\nstatic = true\nz = [1]", ":6: [initial] has both 'static' and 'z'"},
    {time + "[initial]\nvelocity = [1]\nmotion = 'm.h5'", ":6: [initial] has both 'velocity' and 'motion'"},
    {time + "[initial]\nz = 1", ":5: 'z' of [initial] must be an array of numbers"},
    {time + "[initial]\nz = [1]\ntime = 1", ":6: 'time' of [initial] says more of a 'motion'"},
    {time + "[initial]\nmotion = ''", ":5: 'motion' of [initial] must name a file"},
    {time + "[initial]\nmotion = 'm.h5'\ntime = -1", ":6: 'time' of [initial] must not be negative"},
    {time + "[initial]\ndisplacement = [1]", ":5: unknown key 'displacement' in [initial]"},
    {time + "[[body]]\nname = 'a'\ninitial = {}", ":6: 'initial' of [[body]] needs one of"},
    {time + "[[probe]]\nname = 'p'\nset = 's'\nquantity = 'velocty'",
     ":7: unknown quantity 'velocty'; did you mean 'velocity'?"},
    {time + "[[probe]]\nname = 'p'\nset = 's'\nquantity = []", ":7: 'quantity' of [[probe]] is empty"},
    {time + "[[probe]]\nname = 'p'\nset = 's'\nquantity = ['velocity', 'velocity']",
     ":7: 'quantity' of [[probe]] names a quantity twice"},
    {"[static]\nsteps = 1\n[[probe]]\nname = 'p'\nset = 's'\nquantity = 'velocity'",
     ":6: 'quantity' of [[probe]] must be \"displacement\" in statics"},
    {time + "[[body]]\nmodel = 'a.h5'", "[[body]] needs the key 'name'"},
    {time + "[[body]]\nname = ''", ":5: 'name' of [[body]] names files: it must not be empty"},
    {time + "[[body]]\nname = \"\\u009b31m\"", ":5: 'name' of [[body]] names files: it must not be empty"},
    {time + "[[body]]\nname = 'a'\nmodel = ''", ":6: 'model' of [[body]] must name a file"},
    {time + "[[body]]\nname = 'a'\nmodel_body = ''", ":6: 'model_body' of [[body]] must name a body"},
    {time + "[[body]]\nname = 'a'\n[[body]]\nname = 'a'", ":7: two bodies are named 'a'"},
    {time + "[[body]]\nname = 'a'\nmodle = 'm.h5'", ":6: unknown key 'modle' in [[body]]; did you mean 'model'?"},
    {time + "[[load]]\nbody = 'a'\nset = 's'\ntotal = [1, 0, 0]",
     ":5: 'body' of [[load]] names a body, and the scene has"},
    {time + "[[body]]\nname = 'arm'\n[[load]]\nbody = 'amr'\nset = 's'\ntotal = [1, 0, 0]",
     ":7: the scene has no body 'amr'; did you mean 'arm'?"},
    {time + "[[body]]\nname = 'a'\n[[body]]\nname = 'b'\n[[load]]\nset = 's'\ntotal = [1, 0, 0]",
     ":8: [[load]] needs the key 'body', since the scene has several"},
    {time + "[[body]]\nname = 'a'\n[[body]]\nname = 'b'\n[[probe]]\nname = 'p'\nset = 's'",
     ":8: [[probe]] needs the key 'body', since the scene has several"},
    {time + "[shake]\ndirection = [0, 0, 0]\ntable = [[0, 1]]", ":5: 'direction' of [shake] has no length"},
    {time + "[shake]\ntable = [[0, 1]]", ":4: [shake] needs the key 'direction'"},
    {time + "[shake]\ndirection = [1, 0, 0]\ntable = []", ":6: 'table' of [shake] must have at least one pair"},
    {time + "[shake]\ndirection = [1, 0, 0]\ntable = [[0, 1], [1]]",
     ":6: each row of 'table' of [shake] must be a pair"},
    {time + "[shake]\ndirection = [1, 0, 0]\ntable = [0, 1]", ":6: 'table' of [shake] must be an array of numbers"},
    {time + "[shake]\ndirection = [1, 0, 0]\ntable = [[1, 1], [0, 1]]",
     ":6: the times of 'table' of [shake] must ascend"},
    {time + "[shake]\ndirection = [1, 0, 0]\ntable = [[0, 1],\n[0, 2]]",
     ":7: the times of 'table' of [shake] must ascend"},
    {time + "[load]\nset = 'a'\ntotal = [0, 0, 1]", ":4: [[load]] must be an array of tables"},
    {"load = [1, 2]\n" + time, ":1: [[load]] must be a table of keys"},
    {time + "[[load]]\ntotal = [0, 0, 1]", ":4: [[load]] needs a 'set' or a 'vertex'"},
    {time + "[[load]]\nset = 'a'", ":4: [[load]] needs one of 'total', 'each', 'pressure' and 'traction'"},
    {time + "[[load]]\nset = 'a'\nvertex = 1\ntotal = [0, 0, 1]", ":6: [[load]] has both 'set' and 'vertex'"},
    {time + "[[load]]\nset = 'a'\ntotal = [0, 0, 1]\neach = [0, 0, 1]", ":7: [[load]] has both 'total' and 'each'"},
    {time + "[[load]]\nset = 5\ntotal = [0, 0, 1]", ":5: 'set' of [[load]] must be a string"},
    {time + "[[load]]\nvertex = '5'\ntotal = [0, 0, 1]", ":5: 'vertex' of [[load]] must be a whole number"},
    {time + "[[load]]\nvertex = 5\npressure = 1", ":6: 'pressure' of [[load]] acts on a surface set, not on a vertex"},
    {time + "[[load]]\nset = 'a'\npressure = [1, 2, 3]", ":6: 'pressure' of [[load]] must be a number"},
    {time + "[[load]]\nset = 'a'\ntotal = 5", ":6: 'total' of [[load]] must be an array of numbers"},
    {time + "[[load]]\nset = 'a'\ntotl = [0, 0, 1]", ":6: unknown key 'totl' in [[load]]; did you mean 'total'?"},
    {time + "[[load]]\nset = 'a'\ntotal = [0, 0, 1]\ntable = [[0, inf]]",
     ":7: 'table' of [[load]] must be a finite number"},
    {time + "[[probe]]\nset = 'a'", ":4: [[probe]] needs the key 'name'"},
    {time + "[[probe]]\nname = 'a'", ":4: [[probe]] needs a 'set' or a 'vertex'"},
    {time + "[[probe]]\nname = 'a,b'\nset = 'a'", ":5: 'name' of [[probe]] heads a column"},
    {time + "[[probe]]\nname = ''\nset = 'a'", ":5: 'name' of [[probe]] heads a column"},
    {time + "[[probe]]\nname = \"\\u001b[31m\"\nset = 'a'", ":5: 'name' of [[probe]] heads a column"},
    {time + "[[probe]]\nname = 'p'\nset = 'a'\n[[probe]]\nname = 'p'\nset = 'b'", ":8: two probes are named 'p'"},
};

TEST(BadScenes, EachCostsOneSentence) {
  for (const auto& bad : bad_scenes) {
    const test::TemporaryScene file(bad.text);
    try {
      read(file.path());
      ADD_FAILURE() << "was accepted:\n" << bad.text;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith(file.path().string() + ":")) << bad.text;
      EXPECT_THAT(error.what(), testing::HasSubstr(bad.complaint)) << bad.text;
      EXPECT_THAT(error.what(), testing::Not(testing::HasSubstr("\n"))) << bad.text;
    } catch (const std::exception& error) {
      ADD_FAILURE() << "threw something else, " << error.what() << ", for:\n" << bad.text;
    }
  }
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

TEST(BadScenes, OfAnyDepthCostOneSentence) {
  constexpr int deep = 100000;
  const std::string keys = "a" + repeated(".a", deep), quoted = "a" + repeated(" . \"a.b\"", deep);
  for (const auto& text :
       {keys + " = 1", quoted + " = 1", "[" + keys + "]", "[[" + keys + "]]", "x = {" + keys + " = 1}",
        "x = " + repeated("[", deep), "x = " + repeated("{x = ", deep), "s = \"\"\"\n.\"\"\"\n" + keys + " = 1"}) {
    try {
      parse(text, "s.toml");
      ADD_FAILURE() << "was accepted: " << text.substr(0, 40);
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith("s.toml:")) << text.substr(0, 40);
      EXPECT_THAT(error.what(), testing::Not(testing::HasSubstr("\n"))) << text.substr(0, 40);
      EXPECT_LT(std::string(error.what()).size(), 300) << text.substr(0, 40);
    }
  }
}

TEST(BadScenes, DotsAreNoDepthInTextCommentsAndNumbers) {
  const std::string dots(1000, '.');
  EXPECT_NO_THROW(parse("# " + dots + "\ngravity = [0.1" + repeated(", 0.1", 2) + "]\n" + time +
                            "[[probe]]\nname = 'a" + dots + "'\nset = \"\"\"\n" + dots +
                            "\"\"\"\n[[load]]\nset = \"\\\"" + dots + "\"\ntotal = [0.0, 0.0, 1.5]\ntable = [" +
                            repeated("[0.5, 0.5]", 1) + "]\n",
                        "s.toml"));
}

TEST(BadScenes, APipeIsNoFile) {
  const auto pipe = std::filesystem::temp_directory_path() / ("ritz_pipe_" + std::to_string(getpid()));
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT([&] { read(pipe); }, testing::ThrowsMessage<InputError>(testing::HasSubstr("not a regular file")));
  std::filesystem::remove(pipe);
  EXPECT_THAT([] { read("/dev/zero"); }, testing::ThrowsMessage<InputError>(testing::HasSubstr("not a regular file")));
}

TEST(BadScenes, AFileThatCannotBeRead) {
  EXPECT_THROW(read("/nowhere/scene.toml"), InputError);
  EXPECT_THROW(read(std::filesystem::temp_directory_path()), InputError);
}

}  // namespace
}  // namespace ritz::scene
