// A question as text: its name, options and the answer in JSON.
#include <iostream>
#include <taut/ask.hpp>
#include <taut/io.hpp>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: ask SCENE\n";
    return 2;
  }
  const taut::Scene scene = taut::read_scene(argv[1]);
  const taut::Reply reply = taut::ask({"clearance", R"({"pairs": "all", "max_seconds": 5})"}, scene);
  std::cout << reply.json << '\n';
}
