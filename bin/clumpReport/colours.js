// The colours of the types of clumps, which the reader can choose; they are kept by the browser
// where it allows that, and a change is told to the view and the plots.
const colours = [...document.querySelectorAll("input[data-kind]")];

function colourOf(kind) {
    return colours[kind].value;
}

for (const input of colours) {
    const key = "colour of " + input.name;
    try {
        input.value = localStorage.getItem(key) || input.value;
    } catch (refused) { /* not kept */ }
    input.addEventListener("input", () => {
        try {
            localStorage.setItem(key, input.value);
        } catch (refused) { /* not kept */ }
        document.dispatchEvent(new Event("colours"));
    });
}
