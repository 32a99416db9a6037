// Building and writing of schemas.
#include "text/json_schema.h"

#include <json/reader.h>
#include <json/writer.h>

#include <memory>
#include <stdexcept>

namespace nephrite::json {

Json::Value schemaFragment(std::string_view text) {
    const std::unique_ptr<Json::CharReader> reader(Json::CharReaderBuilder().newCharReader());
    Json::Value value;
    std::string faults;
    if (!reader->parse(text.data(), text.data() + text.size(), &value, &faults))
        throw std::logic_error(faults);
    return value;
}

Json::Value objectSchema(std::span<const Key> keys, std::string_view doc) {
    Json::Value schema(Json::objectValue);
    schema["type"] = "object";
    schema["description"] = std::string(doc);
    schema["additionalProperties"] = false;
    for (const Key& key : keys) {
        Json::Value property = schemaFragment(key.schema);
        if (property.isMember("$ref")) {
            // Draft 4 ignores what stands beside a $ref.
            Json::Value reference = std::move(property);
            property = Json::Value(Json::objectValue);
            property["allOf"].append(std::move(reference));
        }
        property["description"] = std::string(key.doc);
        schema["properties"][std::string(key.name)] = std::move(property);
        if (key.required) schema["required"].append(std::string(key.name));
    }
    return schema;
}

Json::Value definition(std::string_view name) {
    Json::Value schema(Json::objectValue);
    schema["$ref"] = "#/definitions/" + std::string(name);
    return schema;
}

Json::Value numberSchema(double least, double most, bool open) {
    Json::Value schema(Json::objectValue);
    schema["type"] = "number";
    schema["minimum"] = least;
    schema["maximum"] = most;
    if (open) schema["exclusiveMinimum"] = schema["exclusiveMaximum"] = true;
    return schema;
}

Json::Value wholeNumberSchema(double least, double most) {
    Json::Value schema = numberSchema(least, most);
    schema["multipleOf"] = 1;  // draft 4's "integer" refuses 2.0
    return schema;
}

Json::Value arraySchema(Json::Value element, unsigned count) {
    Json::Value schema(Json::objectValue);
    schema["type"] = "array";
    schema["minItems"] = schema["maxItems"] = count;
    schema["items"] = std::move(element);
    return schema;
}

Json::Value namedSchema(std::string_view pattern, Json::Value value) {
    Json::Value schema(Json::objectValue);
    schema["type"] = "object";
    schema["additionalProperties"] = false;
    schema["patternProperties"][std::string(pattern)] = std::move(value);
    return schema;
}

Json::Value anyOf(std::initializer_list<Json::Value> choices) {
    Json::Value schema(Json::objectValue);
    for (const Json::Value& choice : choices) schema["anyOf"].append(choice);
    return schema;
}

std::string schemaDocument(Json::Value schema, std::string_view title, Json::Value definitions) {
    schema["$schema"] = "http://json-schema.org/draft-04/schema#";
    schema["title"] = std::string(title);
    schema["definitions"] = std::move(definitions);
    Json::StreamWriterBuilder builder;
    builder["indentation"] = "  ";
    return Json::writeString(builder, schema) + "\n";
}

}  // namespace nephrite::json
