# unit tests of src/scene
