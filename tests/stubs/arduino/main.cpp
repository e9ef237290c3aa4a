// What Arduino has around a sketch: one pass of its loop, for a test.
void setup();
void loop();

int main()
{
    setup();
    loop();
    return 0;
}
