// SPDX-License-Identifier: Apache-2.0
#pragma once
/// Mistakes in deck gear for wires, see malformed_table.h.

#include "good_scenes.h"

#include <string_view>

namespace hawser::scene::test {

struct Mistake {
    std::string_view scene;
    std::string_view patch;
    std::string_view path;
    std::string_view words;
};

// clang-format off
inline constexpr Mistake kGearMistakes[] = {
// --- deck gear ------------------------------------------------------------------------------
{kPendulum, R"([{"op":"add","path":"/stoppers","value":[{"name":"jaw","on":"bub","point":[0,0,0],"rated_load":1e6}]}])", "/stoppers/0/on", "did you mean \"bob\""},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/stoppers","value":[{"name":"jaw","on":"quay","point":[0,0,0]}]}])", "/stoppers/0", "rated_load"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/stoppers","value":[{"name":"jaw","on":"quay","point":[0,0,0],"rated_load":1e6}]},{"op":"add","path":"/inputs","value":[{"name":"shut","signal":"jaw.close","min":0,"max":2}]}])", "/inputs/0/max", "accepts 0 to 1"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/stoppers","value":[{"name":"jaw","on":"quay","point":[0,0,0],"rated_load":1e6}]},{"op":"add","path":"/inputs","value":[{"name":"shut","signal":"jaw.close","factor":-1,"min":-1,"max":1}]}])", "/inputs/0/max", "sets it to -1"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/stoppers","value":[{"name":"jaw","on":"quay","point":[0,0,0],"rated_load":1e6,"outboard":[0,0,0]}]}])", "/stoppers/0", "no direction"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/stoppers","value":[{"name":"jaw","on":"quay","point":[0,0,0],"rated_load":1e6},{"name":"jaw","on":"quay","point":[0,0,0],"rated_load":1e6}]}])", "/stoppers/1/name", "exists already"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/stoppers","value":[{"name":"jaw","on":"quay","point":[0,0,0],"rated_load":1e6,"pitch":0.01}]}])", "/stoppers/0", "0.05"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/stoppers","value":[{"name":"jaw","on":"quay","point":[0,0,0],"rated_load":1e6,"reach_":1}]}])", "/stoppers/0/reach_", "did you mean"},
{kSite, R"([{"op":"add","path":"/stoppers","value":[{"name":"jaw","on":"ship","point":[0,60,0],"rated_load":1e7,"closed":true},{"name":"chock","on":"ship","point":[0,60.05,0],"rated_load":1e7,"closed":true}]}])", "/stoppers/1/point", "start one of them open"},
{kPendulum, R"([{"op":"add","path":"/pins","value":[{"name":"pin","on":"bub","from":[0,0,0],"to":[0,0,1],"radius":0.1}]}])", "/pins/0/on", "no body"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/pins","value":[{"name":"pin","on":"quay","from":[0,0,1],"to":[0,0,1],"radius":0.1}]}])", "/pins/0", "shorter"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/pins","value":[{"name":"pin","on":"quay","from":[0,0,0],"to":[0,0,1],"radius":0.1,"force":10}]}])", "/pins/0", "weight"},
{kPendulum, R"([{"op":"add","path":"/hooks","value":[{"name":"h","on":"bub","loads":[{"body":"bob","sling_length":1,"sling_EA":1e6}]}]}])", "/hooks/0/on", "did you mean \"bob\""},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/hooks","value":[{"name":"h","on":"quay"}]}])", "/hooks/0", "loads"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/hooks","value":[{"name":"h","on":"quay","loads":[{"body":"bub","sling_length":1,"sling_EA":1e6}]}]}])", "/hooks/0/loads/0/body", "did you mean \"bob\""},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/hooks","value":[{"name":"h","on":"quay","loads":[{"body":"bob","sling_length":1,"sling_EA":1e6}],"latsch":1}]}])", "/hooks/0/latsch", "did you mean \"latch\""},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/hooks","value":[{"name":"h","on":"quay","loads":[{"body":"bob","sling_length":1,"sling_EA":1e6}],"take":"bub"}]}])", "/hooks/0/take", "did you mean \"bob\""},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/hooks","value":[{"name":"h","on":"quay","point":[0,0,50],"loads":[{"body":"bob","sling_length":1,"sling_EA":1e6}],"take":"bob"}]}])", "/hooks/0/take", "attach it later, or move the hook nearer"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/hooks","value":[{"name":"h","on":"quay","loads":[{"body":"bob","sling_length":1,"sling_EA":1e6},{"body":"quay","sling_length":1,"sling_EA":1e6}]}]}])", "/hooks/0/loads/1/body", "a hook cannot attach itself"},
{kSite, R"([{"op":"add","path":"/hooks","value":[{"name":"h","on":"ship","loads":[{"body":"hook","eyes":[[0,0,1]],"sling_length":1,"sling_EA":1e6}]}]}])", "/hooks/0/loads/0/eyes", "its one eye is [0, 0, 0]"},
{kSite, R"([{"op":"add","path":"/hooks","value":[{"name":"h","on":"ship","loads":[{"body":"pile","sling_length":1,"sling_EA":1e6}]}]}])", "/hooks/0/loads/0/body", "a rigid body or a lump"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/chasers","value":[{"name":"c","on":"quay"}]}])", "/chasers/0", "a fixed ring is a guide"},
{kPendulum, R"([{"op":"add","path":"/chasers","value":[{"name":"c","on":"bub"}]}])", "/chasers/0/on", "did you mean \"bob\""},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/chasers","value":[{"name":"c","on":"quay","reech":1}]}])", "/chasers/0/reech", "did you mean \"reach\""},
{kPendulum, R"([{"op":"add","path":"/chasers","value":[{"name":"c","on":"bob","reach":0}]}])", "/chasers/0/reach", "greater than 0"},
{kSite, R"([{"op":"add","path":"/chasers","value":[{"name":"c","on":"buoy"},{"name":"c","on":"buoy"}]}])", "/chasers/1/name", "exists already"},
// --- capsules up to the ends of cables ------------------------------------------------------
{kSite, R"([{"op":"add","path":"/cables/1/contact","value":{"to_end":true}}])", "/cables/1/contact/to_end", "did you mean \"to_ends\""},
{kSite, R"([{"op":"add","path":"/cables/1/contact","value":{"to_ends":1}}])", "/cables/1/contact/to_ends", "true or false"},
{kSite, R"([{"op":"add","path":"/cables/2/contact","value":{"to_ends":true}}])", "/cables/2/contact/to_ends", "leave it out"},
{kSite, R"([{"op":"replace","path":"/cables/3/line_type","value":{"mass_per_length":23,"EA":2e8}},{"op":"add","path":"/cables/3/contact","value":{"to_ends":true}}])", "/cables/3/contact", "needs \"radius\", or \"diameter\""},
// --- bollards --------------------------------------------------------------------------------
{kPendulum, R"([{"op":"add","path":"/posts","value":[{"name":"pin","on":"bub","from":[0,0,0],"to":[0,0,1],"radius":0.1}]}])", "/posts/0/on", "did you mean \"bob\""},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","from":[0,0,1],"to":[0,0,1],"radius":0.1}]}])", "/posts/0/to", "no length"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","to":[0,0,1],"radius":0.1}]}])", "/posts/0", "needs \"from\""},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed","box":[6,4,2]}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","edge":[1,0,1],"to":[0,0,1],"radius":0.1}]}])", "/posts/0/to", "leave out"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed","box":[6,4,2]}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","edge":[1,1,1],"radius":0.1}]}])", "/posts/0/edge", "one 0"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed","box":[6,4,2]}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","edge":[1,0,0],"radius":0.1}]}])", "/posts/0/edge", "one 0"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","edge":[1,0,1],"radius":0.1}]}])", "/posts/0/edge", "no box"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed","box":[6,4,2]}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","edge":[1,0,1],"radius":2.5}]}])", "/posts/0/radius", "thinner"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed","shapes":[{"name":"wall","kind":"box","half_size":[6,4,2]}]}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","edge_of":{"shape":"walls","sharper_than":1},"radius":0.1}]}])", "/posts/0/edge_of/shape", "wall"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed","shapes":[{"name":"wall","kind":"box","half_size":[6,4,2]}]}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","edge_of":{"sharper_than":1},"radius":2.5}]}])", "/posts/0/edge_of", "thinner"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","edge_of":{"sharper_than":1},"radius":0.1}]}])", "/posts/0/edge_of", "no shape with edges"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed","box":[6,4,2]}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","edge":[1,0,1],"edge_of":{"sharper_than":1},"radius":0.1}]}])", "/posts/0/edge_of", "leave out"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","from":[0,0,0],"to":[0,0,1],"radius":0.1,"slides":1}]}])", "/posts/0/slides", "true or false"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","from":[0,0,0],"to":[0,0,1],"radius":0.1,"slids":true}]}])", "/posts/0/slids", "did you mean \"slides\""},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","from":[0,0,0],"to":[0,0,1],"radius":0}]}])", "/posts/0/radius", "greater than 0"},
{kPendulum, R"([{"op":"add","path":"/bodies/1","value":{"name":"quay","kind":"fixed"}},{"op":"add","path":"/posts","value":[{"name":"pin","on":"quay","from":[0,0,0],"to":[0,0,1],"radius":0.1,"efficiency":0}]}])", "/posts/0", "above 0"},
};
// clang-format on

}  // namespace hawser::scene::test
