"""The atelier's meshes. Right-handed, +Y up, metres; angles in radians."""
